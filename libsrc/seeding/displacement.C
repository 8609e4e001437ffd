#include "seeding/pointGrid.H"
#include "seeding/seeding.H"

namespace gpuFsi
{

//- Uniform in -1..1 (splitmix64 of the three numbers)
static double random(std::uint64_t seed, std::uint64_t particle, int axis)
{
    std::uint64_t z = seed*0xd1342543de82ef95ull + 3*particle + axis;
    for (int round = 0; round < 2; ++round)
    {
        z += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30))*0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27))*0x94d049bb133111ebull;
        z ^= z >> 31;
    }
    return double(z >> 11)*(2.0/9007199254740992.0) - 1;
}


void displaceBulk
(
    const lattice& l,
    seededParticles& particles,
    double share,
    std::uint64_t seed
)
{
    const double h = l.h();
    pointGrid walls(l, h);
    for (const wallParticle& w : particles.walls)
    {
        walls.insert(w.position);
    }
    for (std::size_t i = 0; i < particles.bulk.size(); ++i)
    {
        vector& p = particles.bulk[i];
        vector d{0, 0, 0};
        for (int axis = 0; axis < l.dimensions(); ++axis)
        {
            component(d, axis) = share*h*random(seed, i, axis);
        }
        // Beside a wall, less of it where it would lead through
        double part = 1;
        const auto visit = [&](std::size_t q, double)
        {
            const vector n = particles.walls[q].normal;
            const double away = dot(l.difference(p, walls[q]), n);
            const double towards = -dot(d, n);
            if (away > 0 && towards > 0)
            {
                part = std::min
                (
                    part, std::max(0.0, away - 0.1*h)/towards
                );
            }
        };
        walls.within(p, 1.5*h, visit);
        p = l.wrap(p + part*d);
    }
}

} // namespace gpuFsi
