// The texts of the work-precision benchmark: tables as CSV and for reading. Writes no file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/exact_answers.h"
#include "work_precision.h"

namespace wells {

/// One case with all methods that ran.
struct CaseResult {
  std::string scene;
  std::string about;
  double duration = 0;  // s
  ErrorKind error = ErrorKind::Position;
  std::vector<Ladder> ladders;
};

/// How soon the methods of a case are within an error.
struct CaseReach {
  std::string scene;
  double error = 0;
  std::string_view unit;  // of the error
  Reach ours;             // the default method
  Reach bestOfOurs;
  Reach published;  // the best of the custom integrator's variants as published
  Reach textbook;   // the best of those with the textbook methods that they are named after
  Reach bullet;
};

/// The errors, in the unit of the case, at which methods are compared.
std::span<const double> comparedErrors();

/// For each case all of comparedErrors().
std::vector<CaseReach> compare(std::span<const CaseResult> cases);

/// One row a point.
std::string pointsCsv(const CaseResult& result);

/// One row a case and error.
std::string overviewCsv(std::span<const CaseReach> reaches);

/// The same as a table for reading.
std::string overviewText(std::span<const CaseReach> reaches);

/// What was measured with what and on what, and what was not run.
std::string conditionsText(std::span<const CaseResult> cases, std::string_view command);

}  // namespace wells
