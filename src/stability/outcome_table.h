// Outcomes as a file: comma-separated values.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "stability/run.h"

namespace tetralux::stability {

// One line per region and method, "region,method,rmse,largest,non_finite,worst_case", numbers in the shortest form that
// reads back as the same; empty numbers where a method does not apply.
std::string outcomeCsv(std::span<const Outcome> outcomes);

// Reads it back. Throws Error(Input) that names the line.
std::vector<Outcome> readOutcomeCsv(const std::filesystem::path& path);

}  // namespace tetralux::stability
