// SPDX-License-Identifier: GPL-2.0-or-later
// The folder of a case, which main.cpp reads its files from.
namespace flowslide {

extern const char* const case_folder;
const char* const case_folder = FLOWSLIDE_CASE_FOLDER;

}  // namespace flowslide
