/// \file
/// Results of the verification: a table of expected and measured values, and data for figures.
#pragma once

#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

namespace shell_origami {

/// One line of the table. It holds when |measured - expected| <= tolerance.
struct VerifiedRow {
  std::string item;      ///< number and name of the closed form
  std::string quantity;  ///< with its unit
  double expected, measured, tolerance;
  std::string why;  ///< reason for the tolerance

  bool holds() const;
};

/// The data of one figure: a CSV file with a header.
class FigureData {
 public:
  FigureData(const std::string& path, const std::vector<std::string>& columns);
  void row(std::initializer_list<double> values);
  /// A row that begins with a word.
  void row(const std::string& name, std::initializer_list<double> values);

 private:
  std::ofstream file_;
};

/// Collects the rows of all topics. A fast run uses coarser meshes and fewer samples.
class VerificationReport {
 public:
  VerificationReport(std::string folder, bool fast) : folder_(std::move(folder)), fast_(fast) {}

  bool fast() const { return fast_; }
  void add(VerifiedRow row);
  FigureData figure(const std::string& name, const std::vector<std::string>& columns) const;

  const std::vector<VerifiedRow>& rows() const { return rows_; }
  /// Writes results.csv into the folder.
  void write() const;

 private:
  std::string folder_;
  bool fast_;
  std::vector<VerifiedRow> rows_;
};

}  // namespace shell_origami
