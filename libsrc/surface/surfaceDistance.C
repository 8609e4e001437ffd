#include "surface/surfaceDistance.H"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace gpuFsi
{

namespace
{

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using triangle = kernel::Triangle_3;
using iterator = std::vector<triangle>::const_iterator;
using primitive = CGAL::AABB_triangle_primitive<kernel, iterator>;
using boxTree = CGAL::AABB_tree<CGAL::AABB_traits<kernel, primitive>>;

kernel::Point_3 point(const vector& p)
{
    return {p.x, p.y, p.z};
}

//- Where the edge a b meets z = 0
vector foot(const vector& a, const vector& b)
{
    vector p = a + (a.z/(a.z - b.z))*(b - a);
    p.z = 0;
    return p;
}

} // namespace

struct surfaceDistance::tree
{
    std::vector<triangle> triangles;
    std::vector<vector> normals;    // by triangle
    boxTree boxes;

    void add
    (
        const vector& a,
        const vector& b,
        const vector& c,
        const vector& normal
    )
    {
        triangles.emplace_back(point(a), point(b), point(c));
        normals.push_back((1/magnitude(normal))*normal);
    }

    //- The cut of a triangle with z = 0 as a strip across the plane: what is
    //  nearest to a place in the plane lies in the plane
    void addCut(const triangleSurface& s, std::size_t t)
    {
        std::vector<vector> ends;
        for (int i = 0; i < 3; ++i)
        {
            const vector& a = s.corner(t, i);
            const vector& b = s.corner(t, (i + 1) % 3);
            if ((a.z < 0) != (b.z < 0))
            {
                ends.push_back(foot(a, b));
            }
        }
        vector n = s.normal(t);
        n.z = 0;
        if (ends.size() < 2 || !(magnitude(n) > 0))
        {
            return;
        }
        const vector along = ends[1] - ends[0];
        const vector up{0, 0, magnitude(along)};
        if (!(up.z > 0))
        {
            return;
        }
        add(ends[0] - up, ends[1] - up, ends[1] + up, n);
        add(ends[0] - up, ends[1] + up, ends[0] + up, n);
    }
};


surfaceDistance::surfaceDistance(const triangleSurface& s, int dimensions)
:
    tree_(std::make_unique<tree>())
{
    for (std::size_t t = 0; t < s.triangles.size(); ++t)
    {
        if (dimensions == 2)
        {
            tree_->addCut(s, t);
            continue;
        }
        tree_->add(s.corner(t, 0), s.corner(t, 1), s.corner(t, 2), s.normal(t));
    }
    tree_->boxes.insert(tree_->triangles.begin(), tree_->triangles.end());
    tree_->boxes.build();
}


surfaceDistance::~surfaceDistance() = default;


std::optional<surfacePoint> surfaceDistance::nearest(const vector& p) const
{
    if (tree_->triangles.empty())
    {
        return {};
    }
    const auto [on, which] =
        tree_->boxes.closest_point_and_primitive(point(p));
    const auto number = iterator(which) - tree_->triangles.cbegin();
    return surfacePoint
    {
        {on.x(), on.y(), on.z()}, tree_->normals[number], 0
    };
}

} // namespace gpuFsi
