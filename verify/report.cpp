#include "verify/report.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace shell_origami {
namespace {

std::ofstream open(const std::string& path) {
  std::ofstream file(path);
  if (!file) throw std::runtime_error("cannot write " + path);
  file.precision(12);
  return file;
}

/// RFC 4180: quotes around it, quotes inside doubled.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

bool VerifiedRow::holds() const { return std::abs(measured - expected) <= tolerance; }

FigureData::FigureData(const std::string& path, const std::vector<std::string>& columns)
    : file_(open(path)) {
  for (std::size_t i = 0; i < columns.size(); ++i) file_ << (i ? "," : "") << columns[i];
  file_ << '\n';
}

void FigureData::row(std::initializer_list<double> values) {
  const char* comma = "";
  for (double value : values) file_ << std::exchange(comma, ",") << value;
  file_ << '\n';
}

void FigureData::row(const std::string& name, std::initializer_list<double> values) {
  file_ << quoted(name);
  for (double value : values) file_ << ',' << value;
  file_ << '\n';
}

void VerificationReport::add(VerifiedRow row) {
  std::printf("%-4s %-58s expected %12.6g  measured %12.6g  tolerance %8.2g\n",
              row.holds() ? "ok" : "OFF", (row.item + ": " + row.quantity).c_str(), row.expected,
              row.measured, row.tolerance);
  std::fflush(stdout);
  rows_.push_back(std::move(row));
}

FigureData VerificationReport::figure(const std::string& name,
                                      const std::vector<std::string>& columns) const {
  return {folder_ + "/" + name + ".csv", columns};
}

void VerificationReport::write() const {
  std::ofstream file = open(folder_ + "/results.csv");
  file << "item,quantity,expected,measured,tolerance,holds,why\n";
  for (const VerifiedRow& row : rows_) {
    file << quoted(row.item) << ',' << quoted(row.quantity) << ',' << row.expected << ','
         << row.measured << ',' << row.tolerance << ',' << row.holds() << ',' << quoted(row.why)
         << '\n';
  }
}

}  // namespace shell_origami
