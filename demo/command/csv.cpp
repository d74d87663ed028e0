#include "csv.h"

#include "number.h"

#include <algorithm>

namespace tsuya::command {

namespace {

// Splits a line at the commas outside quotes; false when a quote does not end.
bool split(std::string_view line, std::vector<std::string_view> &cells)
{
    cells.clear();
    std::size_t from = 0;
    bool quoted = false;
    for (std::size_t at = 0; at <= line.size(); at++) {
        if (at == line.size() || (line[at] == ',' && !quoted)) {
            cells.push_back(trimmed(line.substr(from, at - from)));
            from = at + 1;
        } else if (line[at] == '"') {
            quoted = !quoted;
        }
    }
    return !quoted;
}

std::string_view unquoted(std::string_view cell)
{
    const bool quotes = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
    return quotes ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

bool control(unsigned char c)
{
    return c < ' ' && c != '\t';
}

std::string at_line(std::size_t number)
{
    return "line " + std::to_string(number);
}

} // namespace

std::string_view Csv::text(const Line &line) const
{
    return std::string_view(text_).substr(line.from, line.size);
}

bool Csv::header(const Line &line, std::string &error)
{
    std::vector<std::string_view> cells;
    if (!split(text(line), cells)) {
        error = at_line(line.number) + ": a quote does not end.";
        return false;
    }
    double number;
    if (std::all_of(cells.begin(), cells.end(),
                    [&](std::string_view cell) { return parse_number(unquoted(cell), number); })) {
        error = at_line(line.number) + ": there are numbers where the header line must be; the "
                                       "first line names the columns.";
        return false;
    }
    for (const std::string_view cell : cells) {
        const std::string name(unquoted(cell));
        const std::string where =
            at_line(line.number) + ": column " + std::to_string(columns_.size() + 1);
        if (name.empty()) {
            error = where + " of the header has no name.";
            return false;
        }
        if (std::any_of(name.begin(), name.end(), control)) {
            error = where + " of the header holds a control character; is this text?";
            return false;
        }
        if (column(name) >= 0) {
            error = where + " repeats the name " + name + " of column " +
                    std::to_string(column(name) + 1) + "; a column may appear once.";
            return false;
        }
        columns_.push_back(name);
    }
    return true;
}

bool Csv::read(std::string text, std::string &error)
{
    text_ = std::move(text);
    lines_.clear();
    rows_.clear();
    columns_.clear();
    std::size_t from = text_.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
    std::size_t number = 0, blank = 0;
    std::vector<std::string_view> cells;
    while (from < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', from), text_.size());
        std::size_t size = end - from;
        size -= size && text_[from + size - 1] == '\r';
        const Line line = {from, size, ++number, size && text_[from] == '#'};
        from = end + 1;
        if (line.comment) {
            lines_.push_back(line);
            continue;
        }
        if (trimmed(this->text(line)).empty()) {
            blank = blank ? blank : number;
            continue;
        }
        if (blank) {
            error = at_line(blank) + " is blank; blank lines are allowed at the end only.";
            return false;
        }
        lines_.push_back(line);
        if (columns_.empty()) {
            if (!header(line, error)) {
                return false;
            }
            continue;
        }
        const std::string_view line_text = this->text(line);
        if (!split(line_text, cells)) {
            error = at_line(number) + ": a quote does not end.";
            return false;
        }
        if (std::any_of(line_text.begin(), line_text.end(), control)) {
            error = at_line(number) + " holds a control character; is this text?";
            return false;
        }
        if (cells.size() != columns_.size()) {
            error = at_line(number) + " has " + std::to_string(cells.size()) +
                    " cells where the header has " + std::to_string(columns_.size()) + " columns.";
            return false;
        }
        rows_.push_back(lines_.size() - 1);
    }
    if (columns_.empty()) {
        error = "there is no header line; the first line names the columns.";
        return false;
    }
    return true;
}

const std::vector<std::string> &Csv::columns() const
{
    return columns_;
}

int Csv::column(const std::string &name) const
{
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    return found == columns_.end() ? -1 : int(found - columns_.begin());
}

std::size_t Csv::rows() const
{
    return rows_.size();
}

std::size_t Csv::line(std::size_t row) const
{
    return lines_[rows_[row]].number;
}

void Csv::cells(std::size_t row, std::vector<std::string_view> &out) const
{
    split(text(lines_[rows_[row]]), out);
    for (std::string_view &cell : out) {
        cell = unquoted(cell);
    }
}

std::string Csv::write(const std::vector<std::string> &names, const std::vector<double> &values,
                       int digits) const
{
    std::string out;
    out.reserve(text_.size() + values.size() * (std::size_t(digits) + 4));
    std::size_t value = 0;
    bool header = true;
    for (const Line &line : lines_) {
        out += text(line);
        for (std::size_t i = 0; i < names.size() && !line.comment; i++) {
            out += ',';
            if (header) {
                out += names[i];
            } else {
                append_number(out, values[value++], digits);
            }
        }
        header = header && line.comment;
        out += '\n';
    }
    return out;
}

} // namespace tsuya::command
