#include "decomposition/decomposeParDict.H"

namespace gpuFsi
{

static decomposeParDict::costs readCosts(const dictionary& dict)
{
    decomposeParDict::costs c;
    if (const dictionary* weights = dict.subDictPtr("weights"))
    {
        c.fluid = weights->getNumberOrDefault("fluid", c.fluid, 1e-6, 1e6);
        c.wall = weights->getNumberOrDefault("wall", c.wall, 0, 1e6);
    }
    return c;
}


static decomposeParDict::balancing readBalance(const dictionary& dict)
{
    decomposeParDict::balancing b;
    if (!dict.isDict("balance"))
    {
        b.active = dict.getOrDefault("balance", b.active);
        return b;
    }
    const dictionary& balance = dict.subDict("balance");
    b.limit = balance.getNumberOrDefault("limit", b.limit, 1, 1e6);
    b.every = balance.getOrDefault("every", b.every);
    return b;
}


//- Coefficients of methods that were not chosen may stay
static void markOtherCoeffs(const dictionary& dict, const std::string& chosen)
{
    for (const std::string& method : decomposition::selection::words())
    {
        const dictionary* coeffs = method == chosen
          ? nullptr : dict.subDictPtr(method + "Coeffs");
        if (!coeffs)
        {
            continue;
        }
        for (const std::string& key : coeffs->keys())
        {
            if (!coeffs->isDict(key))
            {
                coeffs->tokens(key);
            }
        }
    }
}


decomposeParDict decomposeParDict::read(const std::filesystem::path& casePath)
{
    const std::filesystem::path file = casePath/"system/decomposeParDict";
    if (!std::filesystem::exists(file))
    {
        throw userError
        (
            "There is no file " + file.string(),
            {file.string()},
            "Write one, with at least 'numberOfSubdomains 2;' and 'method"
            " hilbert;': see etc/caseDicts/annotated/decomposeParDict."
        );
    }
    const dictionary dict = dictionary::fromFile(file);
    decomposeParDict d;
    dict.getNumber("numberOfSubdomains", 1, 1e6);
    d.numberOfSubdomains = dict.get<int>("numberOfSubdomains");
    d.methodName = dict.get<std::string>("method");
    d.method = decomposition::make(dict, casePath);
    d.weights = readCosts(dict);
    d.balance = readBalance(dict);
    const std::string transport = dict.getChoiceOrDefault
    (
        "transport", "auto", {"auto", "staged", "direct"}
    );
    d.transport = transport == "auto" ? transportMode::automatic
      : transport == "staged" ? transportMode::staged
      : transportMode::direct;
    markOtherCoeffs(dict, d.methodName);
    dict.warnUnread();
    return d;
}

} // namespace gpuFsi
