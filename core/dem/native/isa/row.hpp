// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// Four numbers that are read, added and stored at once (a vector extension of g++ and clang++, on any processor).
using Row = double __attribute__((vector_size(32), may_alias));

inline Row row_at(const double* numbers) { return *reinterpret_cast<const Row*>(numbers); }
inline void put_row(double* numbers, Row row) { *reinterpret_cast<Row*>(numbers) = row; }
inline void add_row(double* numbers, Row row) { put_row(numbers, row_at(numbers) + row); }

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
