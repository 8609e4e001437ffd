#include "parallel/communicator.H"

#include "base/error.H"
#include "parallel/agreedError.H"

#include <algorithm>

namespace gpuFsi
{

bool communicator::any(bool here) const
{
    std::uint64_t bit = here;
    bitOr(&bit, 1);
    return bit != 0;
}


bool communicator::same(std::uint64_t value) const
{
    std::uint64_t bits[2] = {value, ~value};
    bitOr(bits, 2);
    return bits[0] == ~bits[1];
}


void communicator::agree(const std::function<void()>& f) const
{
    std::string what;
    bool failed = false, ofFile = false;
    try
    {
        f();
    }
    catch (const std::exception& e)
    {
        if (!parallel())
        {
            throw;
        }
        failed = true;
        what = e.what();
        ofFile = namesFile(e);
    }
    if (!parallel() || !any(failed))
    {
        return;
    }
    std::vector<char> note;
    if (failed)
    {
        note.assign(1, ofFile ? 1 : 0);
        note.insert(note.end(), what.begin(), what.end());
    }
    for (const auto& n : gatherAll(note))
    {
        if (!n.empty())
        {
            throw agreedError(std::string(n.begin() + 1, n.end()), n[0] != 0);
        }
    }
}

} // namespace gpuFsi
