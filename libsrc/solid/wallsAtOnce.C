#include "solid/wallsAtOnce.H"

#include "solid/contactGrid.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

//- As wallPlane has it
bool isOneWall(const vector& a, const vector& b)
{
    return dot(a, b) > 0.7;
}


//- Round a convex edge, and on the two sides of a plate, one is touched only
bool backToBack
(
    const contactWalls& walls,
    const nearestImage& image,
    int p,
    int q
)
{
    const vector d = image.offset(walls.points[q], walls.points[p]);
    const double least = 1e-6*walls.spacing;
    return dot(d, walls.normals[p]) < least
        && -dot(d, walls.normals[q]) < least;
}


//- Row of wall particle p
double rowOf
(
    const contactWalls& walls,
    const nearestImage& image,
    int p,
    const std::vector<int>& near
)
{
    const vector& normal = walls.normals[p];
    std::vector<vector> others;
    double row = 1;
    for (const int q : near)
    {
        const vector& n = walls.normals[q];
        const bool seen = isOneWall(n, normal) || std::any_of
        (
            others.begin(), others.end(),
            [&n](const vector& other) { return isOneWall(n, other); }
        );
        if (!seen && !backToBack(walls, image, p, q))
        {
            others.push_back(n);
            row += std::fabs(dot(n, normal));
        }
    }
    return row;
}


bool moveApart(const contactWalls& walls)
{
    return walls.move() && walls.motions.size() > 1;
}

} // namespace


double wallsAtOnce
(
    const contactWalls& walls,
    double within,
    const nearestImage& image
)
{
    if (walls.empty())
    {
        return 0;
    }
    const contactGrid grid(walls.points, within, image.period);
    double most = moveApart(walls) ? 2 : 1;
    std::vector<int> near;
    for (int p = 0; p < int(walls.points.size()); ++p)
    {
        near.clear();
        grid.forNear(walls.points[p], [&](int q)
        {
            const vector d = image.offset(walls.points[p], walls.points[q]);
            if (dot(d, d) < within*within)
            {
                near.push_back(q);
            }
        });
        std::sort(near.begin(), near.end());
        most = std::max(most, rowOf(walls, image, p, near));
    }
    return most;
}

} // namespace gpuFsi
