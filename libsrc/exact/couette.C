//- Fluid between two plates, at rest until one of them is set moving along
//  itself at t = 0: the Fourier series of the start-up (incompressible).
//  Keys: those of column (the plate at s = 0 rests), velocity of the plate at
//  s = length.

#include "exact/column.H"
#include "exact/fourierSums.H"
#include "exact/velocitySolution.H"

namespace gpuFsi
{

namespace
{

class couette
:
    public velocitySolution
{
public:

    couette(const dictionary& dict, const fluidConstants& fluid)
    :
        column_(dict, fluid),
        velocity_(dict.get<vector>("velocity"))
    {
        const double across = dot(velocity_, column_.direction);
        if (across*across > 1e-20*dot(velocity_, velocity_))
        {
            throw userError
            (
                "The plate's velocity is not along the plate",
                dict.where("velocity"),
                "Give a velocity normal to direction."
            );
        }
    }

    std::vector<vector> vectors
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        std::vector<vector> values;
        for (const vector& p : points)
        {
            values.push_back(share(column_.along(p)/column_.length, t)
                *velocity_);
        }
        return values;
    }

private:

    //- Of the plate's velocity, s in lengths
    double share(double s, double t) const
    {
        using fourierSums::pi;
        const double rate = pi*pi*column_.nu/(column_.length*column_.length);
        if (rate*t <= 0)
        {
            return s < 1 ? 0 : 1;
        }
        double sum = s;
        for (int n = 1; n*n*rate*t < 40; ++n)
        {
            sum += (n % 2 ? -2 : 2)/(n*pi)*std::sin(n*pi*s)
                *std::exp(-n*n*rate*t);
        }
        return sum;
    }

    column column_;
    vector velocity_;
};

const exactSolution::selection::add<couette> add("couette");

} // namespace

} // namespace gpuFsi
