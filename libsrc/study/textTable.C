#include "study/textTable.H"

#include "base/error.H"
#include "case/caseFileIO.H"
#include "dictionary/number.H"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace gpuFsi
{

namespace
{

std::vector<std::string> splitTabs(const std::string& line)
{
    std::vector<std::string> values;
    std::istringstream stream(line);
    for (std::string value; std::getline(stream, value, '\t');)
    {
        values.push_back(value);
    }
    return values;
}


std::vector<std::string> splitCommas(const std::string& line)
{
    std::vector<std::string> values(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
        {
            values.back() += line[++i];
        }
        else if (c == '"')
        {
            quoted = !quoted;
        }
        else if (c == ',' && !quoted)
        {
            values.emplace_back();
        }
        else if (c != '\r')
        {
            values.back() += c;
        }
    }
    return values;
}

} // namespace


void textTable::add(std::vector<std::string> values, int line)
{
    if (values.size() != columns_.size())
    {
        throw userError
        (
            fmt::format
            (
                "A row has {} values, but there are {} columns",
                values.size(), columns_.size()
            ),
            {file_.string(), line, line},
            "Each row needs a value for each named column."
        );
    }
    rows_.push_back(std::move(values));
    lines_.push_back(line);
}


textTable textTable::fromTabs(const std::filesystem::path& file)
{
    textTable table;
    table.file_ = file;
    std::istringstream stream(readCaseFile(file));
    int number = 0;
    for (std::string line; std::getline(stream, line);)
    {
        ++number;
        if (line.compare(0, 2, "# ") == 0)
        {
            table.columns_ = splitTabs(line.substr(2));
        }
        else if (!line.empty())
        {
            table.add(splitTabs(line), number);
        }
    }
    return table;
}


textTable textTable::fromCsv(const std::filesystem::path& file)
{
    textTable table;
    table.file_ = file;
    std::istringstream stream(readCaseFile(file));
    int number = 0;
    for (std::string line; std::getline(stream, line);)
    {
        ++number;
        if (line.empty() || line[0] == '#')
        {
            continue;
        }
        if (table.columns_.empty())
        {
            table.columns_ = splitCommas(line);
        }
        else
        {
            table.add(splitCommas(line), number);
        }
    }
    return table;
}


bool textTable::has(const std::string& column) const
{
    return std::find(columns_.begin(), columns_.end(), column)
     != columns_.end();
}


std::string textTable::text(std::size_t row, const std::string& column) const
{
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found == columns_.end())
    {
        throw userError
        (
            unknownChoice("column", column, columns_), {file_.string()},
            "The line of names must hold '" + column + "'."
        );
    }
    return rows_.at(row)[found - columns_.begin()];
}


double textTable::number(std::size_t row, const std::string& column) const
{
    const std::string value = text(row, column);
    double result = 0;
    if (!readNumber(value, result))
    {
        throw userError
        (
            "Column " + column + " holds '" + value + "', a number was "
            "expected",
            {file_.string(), lines_.at(row), lines_.at(row)}
        );
    }
    return result;
}


std::string csvText(const std::string& value)
{
    if (value.find_first_of(",\"") == std::string::npos)
    {
        return value;
    }
    std::string text = "\"";
    for (const char c : value)
    {
        text += c == '"' ? "\"\"" : std::string(1, c);
    }
    return text + '"';
}

} // namespace gpuFsi
