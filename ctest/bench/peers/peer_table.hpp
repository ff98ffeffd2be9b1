// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "peers/peer_codes.hpp"

namespace flowslide {

/// What was measured of a code in one scene.
struct PeerRow {
  const PeerCode* code = nullptr;
  FirstState first;
  std::vector<double> speeds;  ///< steps per second of each turn; the same turns in all rows of a scene
};

double median(std::vector<double> values);

/// The median over the turns of the speed of `engine` with the threads and the rolling part of `row`, over that of
/// `row`. 0 if there is no such engine among the rows.
double times_slower(const PeerRow& row, const std::string& engine, const std::vector<PeerRow>& rows);

/// The speeds of a scene as lines of a Markdown table, under `speed_header`.
std::string speed_lines(const PeerScene& scene, const std::vector<PeerRow>& rows);
std::string speed_header();

/// The initial stresses of a scene as lines of a Markdown table, under `stress_header`.
std::string stress_lines(const PeerScene& scene, const std::vector<PeerRow>& rows);
std::string stress_header();

}  // namespace flowslide
