//- scheme semiLagrangian: along the paths that end in the points, second order
//  in time (trapezoidal, predicted by a step of Euler) and in space
//  (quadratic interpolation at the paths' beginnings, central differences).

#include "gridScheme.H"

#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

//- Lagrange weights of the points -1, 0, 1 at x
struct weights
{
    double w[3];

    explicit weights(double x)
    :
        w{0.5*x*(x - 1), 1 - x*x, 0.5*x*(x + 1)}
    {}
};

//- Field at the point p shifted by (x y z) spacings, each within a half
inline double interpolated
(
    const double* field,
    long p,
    long sy,
    long sz,
    const weights& x,
    const weights& y,
    const weights& z
)
{
    double sum = 0;
    for (int c = 0; c < 3; ++c)
    {
        double plane = 0;
        for (int b = 0; b < 3; ++b)
        {
            const double* row = field + p + (b - 1)*sy + (c - 1)*sz;
            plane += y.w[b]
               *(x.w[0]*row[-1] + x.w[1]*row[0] + x.w[2]*row[1]);
        }
        sum += z.w[c]*plane;
    }
    return sum;
}


class semiLagrangian
:
    public gridScheme
{
public:

    semiLagrangian(const gridState& q, const gridFluid& fluid)
    :
        fluid_(fluid),
        whole_(q),
        half_(q),
        ahead_(q),
        shift_(q)
    {}

    void step(gridState& q, double dt) override
    {
        addRates(q, dt);
        predict(q, dt);
        correct(q, dt);
    }

    std::string describe() const override
    {
        return "semiLagrangian, quadratic, trapezoidal";
    }

private:

    //- whole = q + dt rates, half = q + dt/2 rates
    void addRates(const gridState& q, double dt)
    {
        const double* now[4];
        double* whole[4];
        double* half[4];
        for (int f = 0; f < 4; ++f)
        {
            now[f] = q.field(f);
            whole[f] = whole_.field(f);
            half[f] = half_.field(f);
        }
        forRates<false>(q, fluid_, [=](long p, const double (&rate)[4])
        {
            for (int f = 0; f < 4; ++f)
            {
                whole[f][p] = now[f][p] + dt*rate[f];
                half[f][p] = now[f][p] + 0.5*dt*rate[f];
            }
        });
        whole_.wrap();
        half_.wrap();
    }

    //- ahead: a step of Euler along the path of the present velocity; shift:
    //  the path's beginning by the mean velocity at both its ends
    void predict(const gridState& q, double dt)
    {
        const int n = q.n();
        const long sy = q.rowStride(), sz = q.planeStride();
        const double scale = dt/q.h();
        const double* now[4];
        const double* whole[4];
        double* ahead[4];
        double* shift[4];
        for (int f = 0; f < 4; ++f)
        {
            now[f] = q.field(f);
            whole[f] = whole_.field(f);
            ahead[f] = ahead_.field(f);
            shift[f] = shift_.field(f);
        }
        // A maximum passes over what is no number: bad does not
        double longest = 0;
        int bad = 0;
        #pragma omp parallel for schedule(static) collapse(2) \
            reduction(max : longest) reduction(| : bad)
        for (int k = 0; k < n; ++k)
        {
            for (int j = 0; j < n; ++j)
            {
                const long row = q.index(0, j, k);
                #pragma omp simd reduction(max : longest) reduction(| : bad)
                for (int i = 0; i < n; ++i)
                {
                    const long p = row + i;
                    const double d[3] =
                    {
                        -scale*now[1][p], -scale*now[2][p], -scale*now[3][p]
                    };
                    const weights x(d[0]), y(d[1]), z(d[2]);
                    ahead[0][p] = interpolated(whole[0], p, sy, sz, x, y, z);
                    for (int a = 1; a < 4; ++a)
                    {
                        const double end =
                            interpolated(whole[a], p, sy, sz, x, y, z);
                        const double begin =
                            interpolated(now[a], p, sy, sz, x, y, z);
                        const double s = -0.5*scale*(begin + end);
                        ahead[a][p] = end;
                        shift[a][p] = s;
                        longest = std::fmax(longest, std::fabs(d[a - 1]));
                        longest = std::fmax(longest, std::fabs(s));
                        bad |= !(std::fabs(d[a - 1]) <= 0.5);
                        bad |= !(std::fabs(s) <= 0.5);
                    }
                }
            }
        }
        if (bad)
        {
            failShift(longest);
        }
        ahead_.wrap();
    }

    void correct(gridState& q, double dt)
    {
        const long sy = q.rowStride(), sz = q.planeStride();
        const double* shift[3] =
            {shift_.field(1), shift_.field(2), shift_.field(3)};
        const double* half[4];
        double* now[4];
        for (int f = 0; f < 4; ++f)
        {
            half[f] = half_.field(f);
            now[f] = q.field(f);
        }
        forRates<false>(ahead_, fluid_, [=](long p, const double (&rate)[4])
        {
            const weights x(shift[0][p]), y(shift[1][p]), z(shift[2][p]);
            for (int f = 0; f < 4; ++f)
            {
                now[f][p] = interpolated(half[f], p, sy, sz, x, y, z)
                  + 0.5*dt*rate[f];
            }
        });
        q.wrap();
    }

    [[noreturn]] static void failShift(double longest)
    {
        throw userError
        (
            longest <= 0.5
              ? "The velocity is no longer finite"
              : fmt::format
                (
                    "The flow moves {:.3g} spacings in a step, of which the "
                    "semi-Lagrangian scheme here takes half a one", longest
                ),
            {}, "Use a smaller deltaT."
        );
    }

    gridFluid fluid_;
    gridState whole_, half_, ahead_, shift_;
};

const gridScheme::selection::add<semiLagrangian> add("semiLagrangian");

} // namespace

} // namespace gpuFsi
