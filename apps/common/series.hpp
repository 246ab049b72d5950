#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace seiche::apps {

/// A quantity over time, or over anything else that ascends.
struct Series {
  std::vector<double> t, y;  ///< of equal length

  std::size_t size() const { return t.size(); }

  /// Linear between samples, constant beyond the ends. The series must not be empty.
  double at(double time) const;

  /// Samples of [from, to], both ends included.
  Series between(double from, double to) const;
};

/// Middle of the intervals between the times in order of length (the upper one of two); 0 for fewer than two times.
double median_interval(const std::vector<double>& t);

/// sqrt(sum v^2 / n); NaN for none.
double rms(const std::vector<double>& values);

/// A column of a CSV file with a line of column names, over another one.
/// Throws BadScene where the file, a column or a number is missing.
Series read_series(const std::filesystem::path& file, const std::string& over, const std::string& column);

}  // namespace seiche::apps
