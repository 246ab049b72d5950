#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace seiche::apps {

/// A table of numbers in a text file: a header line of titles, then rows, their cells parted by commas.
class Csv {
 public:
  /// `file` is the text's name in messages. Throws BadScene where there is no header, or a row has more or fewer cells.
  Csv(const std::string& text, std::string file);

  const std::vector<std::string>& titles() const { return titles_; }
  std::size_t rows() const { return rows_.size(); }

  /// Throws BadScene where the cell holds no finite number.
  double number(std::size_t row, std::size_t column) const;

  /// The same, and NaN where the cell is empty.
  double number_or_gap(std::size_t row, std::size_t column) const;

  /// Throws BadScene with file:line of the header, of a row, or of the last line.
  [[noreturn]] void refuse_header(const std::string& what) const;
  [[noreturn]] void refuse(std::size_t row, const std::string& what) const;
  [[noreturn]] void refuse_end(const std::string& what) const;

 private:
  std::string file_;
  std::vector<std::string> titles_;
  std::vector<std::vector<std::string>> rows_;
};

/// The name and the unit in a title, as in "eta_left [m]"; the unit is empty where there is none.
struct CsvTitle {
  std::string name, unit;
};
CsvTitle parted(const std::string& title);

/// The text of a file. Throws BadScene where it can't be read: `what` then says what was looked for, as in "motion
/// file".
std::string read_text_file(const std::string& file, const std::string& what);

/// The file as a table. Throws BadScene, also where it can't be read: `what` then says what was looked for, as in
/// "motion file".
Csv read_csv(const std::string& file, const std::string& what);

}  // namespace seiche::apps
