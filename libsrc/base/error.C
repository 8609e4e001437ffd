#include "base/error.H"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace gpuFsi
{

std::string sourceSpan::text() const
{
    if (file.empty())
    {
        return {};
    }
    if (first <= 0)
    {
        return "file: " + file;
    }
    if (last <= first)
    {
        return "file: " + file + " at line " + std::to_string(first) + '.';
    }
    return "file: " + file + " from line " + std::to_string(first)
        + " to line " + std::to_string(last) + '.';
}


static std::string compose
(
    const std::string& message,
    const sourceSpan& where,
    const std::string& remedy
)
{
    std::string text = message;
    if (!remedy.empty())
    {
        text += "\n    " + remedy;
    }
    if (!where.file.empty())
    {
        text += "\n\n" + where.text();
    }
    return text;
}


userError::userError
(
    const std::string& message,
    const sourceSpan& where,
    const std::string& remedy
)
:
    std::runtime_error(compose(message, where, remedy)),
    where_(where)
{}


void developerAssert(bool holds, const char* what)
{
    if (!holds)
    {
        throw std::logic_error
        (
            std::string("internal error (please report it): ") + what
        );
    }
}


static std::size_t editDistance(const std::string& a, const std::string& b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const bool same = std::tolower(a[i]) == std::tolower(b[j]);
            const std::size_t substitute = diagonal + (same ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] =
                std::min({substitute, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row[b.size()];
}


std::string nearestWord
(
    const std::string& word,
    const std::vector<std::string>& known
)
{
    std::string best;
    std::size_t bestDistance = std::max<std::size_t>(2, word.size()/3) + 1;
    for (const std::string& candidate : known)
    {
        const std::size_t d = editDistance(word, candidate);
        if (d < bestDistance && d < std::max(word.size(), candidate.size()))
        {
            best = candidate;
            bestDistance = d;
        }
    }
    return best;
}


std::string unknownChoice
(
    const std::string& what,
    const std::string& found,
    std::vector<std::string> valid
)
{
    std::sort(valid.begin(), valid.end());
    std::string text = "Unknown " + what + " type " + found;
    const std::string near = nearestWord(found, valid);
    if (!near.empty())
    {
        text += " (did you mean " + near + "?)";
    }
    text += "\n\nValid " + what + " types :\n";
    for (const std::string& v : valid)
    {
        text += "\n    " + v;
    }
    return text;
}


void printFatal(const char* application, const char* what, bool ofFile)
{
    std::fflush(stdout);
    std::fprintf
    (
        stderr,
        "\n\n--> FOAM FATAL %sERROR: \n%s\n\n    From %s\n\nFOAM exiting\n\n",
        ofFile ? "IO " : "", what, application
    );
}


bool namesFile(const std::exception& e)
{
    const auto* user = dynamic_cast<const userError*>(&e);
    return user && !user->where().file.empty();
}


int runMain(const char* application, const std::function<int()>& body)
{
    try
    {
        return body();
    }
    catch (const std::exception& e)
    {
        printFatal(application, e.what(), namesFile(e));
    }
    return 1;
}

} // namespace gpuFsi
