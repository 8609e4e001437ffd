//- schemes finiteDifferences: central differences at fixed points, Heun's
//  second-order steps; and finiteDifferencesEuler: forward Euler steps.

#include "gridScheme.H"

#include <utility>

namespace gpuFsi
{

namespace
{

template<bool SecondOrder>
class finiteDifferences
:
    public gridScheme
{
public:

    finiteDifferences(const gridState& q, const gridFluid& fluid)
    :
        fluid_(fluid),
        ahead_(q)
    {}

    void step(gridState& q, double dt) override
    {
        double* now[4];
        double* next[4];
        for (int f = 0; f < 4; ++f)
        {
            now[f] = q.field(f);
            next[f] = ahead_.field(f);
        }
        forRates<true>(q, fluid_, [=](long p, const double (&rate)[4])
        {
            for (int f = 0; f < 4; ++f)
            {
                next[f][p] = now[f][p] + dt*rate[f];
            }
        });
        ahead_.wrap();
        if (!SecondOrder)
        {
            std::swap(q, ahead_);
            return;
        }
        forRates<true>(ahead_, fluid_, [=](long p, const double (&rate)[4])
        {
            for (int f = 0; f < 4; ++f)
            {
                now[f][p] = 0.5*(now[f][p] + next[f][p] + dt*rate[f]);
            }
        });
        q.wrap();
    }

    std::string describe() const override
    {
        return SecondOrder ? "finiteDifferences, Heun"
                           : "finiteDifferences, Euler";
    }

private:

    gridFluid fluid_;
    gridState ahead_;
};

const gridScheme::selection::add<finiteDifferences<true>>
    second("finiteDifferences");
const gridScheme::selection::add<finiteDifferences<false>>
    first("finiteDifferencesEuler");

} // namespace

} // namespace gpuFsi
