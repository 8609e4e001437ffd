#include "dictionary/keyPattern.H"

namespace gpuFsi
{

keyPattern::keyPattern(const std::string& text, const sourceSpan& where)
{
    const int status = regcomp(&compiled_, text.c_str(), REG_EXTENDED);
    if (status != 0)
    {
        char reason[256];
        regerror(status, nullptr, reason, sizeof reason);
        throw userError
        (
            "Key \"" + text + "\" is not a valid regular expression: "
                + reason,
            where,
            "Quoted keys are POSIX extended regular expressions; a plain key"
            " needs no quotes."
        );
    }
}


keyPattern::~keyPattern()
{
    regfree(&compiled_);
}


bool keyPattern::matches(const std::string& key) const
{
    regmatch_t span;
    return regexec(&compiled_, key.c_str(), 1, &span, 0) == 0
        && span.rm_so == 0 && span.rm_eo == regoff_t(key.size());
}

} // namespace gpuFsi
