// A CSV filter: rows come in, the same rows go out with columns appended.
//
// The text is lines of cells between commas. Lines that begin with `#`, anywhere, pass through.
// The first other line is the header: names in any order, each once. Every further line has as many
// cells as the header. A cell may be quoted with `"` (a quote inside is doubled); commas inside
// quotes belong to the cell, line ends do not. Lines end with LF or CRLF and leave with LF; a byte
// order mark is dropped; blank lines are allowed at the end only.
//
// Lines and columns count from 1 in error texts.
#ifndef TSUYA_DEMO_COMMAND_CSV_H
#define TSUYA_DEMO_COMMAND_CSV_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tsuya::command {

class Csv
{
  public:
    // Takes the whole text. Errors name the line: no header, a column without a name or there
    // twice, a row with too few or too many cells, a quote that does not end.
    bool read(std::string text, std::string &error);

    const std::vector<std::string> &columns() const;
    int column(const std::string &name) const; // -1 when there is none
    std::size_t rows() const;
    std::size_t line(std::size_t row) const; // line number of a row
    // Cells of a row, trimmed of spaces and of their quotes.
    void cells(std::size_t row, std::vector<std::string_view> &out) const;

    // The text with `names` appended to the header and `values` (rows x names) to the rows, written
    // with `digits` significant digits.
    std::string write(const std::vector<std::string> &names, const std::vector<double> &values,
                      int digits) const;

  private:
    struct Line {
        std::size_t from, size;
        std::size_t number;
        bool comment;
    };

    bool header(const Line &line, std::string &error);
    std::string_view text(const Line &line) const;

    std::string text_;
    std::vector<Line> lines_;       // header included
    std::vector<std::size_t> rows_; // indices into lines_
    std::vector<std::string> columns_;
};

} // namespace tsuya::command

#endif
