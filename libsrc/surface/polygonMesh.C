#include "surface/polygonMesh.H"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>

namespace gpuFsi
{

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using polygonMesh = CGAL::Surface_mesh<kernel::Point_3>;
namespace processing = CGAL::Polygon_mesh_processing;

//- Face numbers are triangle numbers
static polygonMesh makeMesh(const triangleSurface& s)
{
    std::vector<kernel::Point_3> points;
    for (const vector& p : s.points)
    {
        points.emplace_back(p.x, p.y, p.z);
    }
    std::vector<std::vector<std::size_t>> triangles;
    for (const auto& t : s.triangles)
    {
        triangles.push_back
        ({
            std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])
        });
    }
    // Parts that meet in a point only get a copy of it each
    processing::orient_polygon_soup(points, triangles);
    polygonMesh mesh;
    processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
    return mesh;
}


std::vector<std::pair<int, int>> selfIntersections(const triangleSurface& s)
{
    const polygonMesh mesh = makeMesh(s);
    std::vector<std::pair<polygonMesh::Face_index, polygonMesh::Face_index>>
        pairs;
    processing::self_intersections(mesh, std::back_inserter(pairs));
    std::vector<std::pair<int, int>> result;
    for (const auto& pair : pairs)
    {
        const int a = int(pair.first.idx());
        const int b = int(pair.second.idx());
        result.emplace_back(std::min(a, b), std::max(a, b));
    }
    std::sort(result.begin(), result.end());
    return result;
}


std::vector<int> sideOf
(
    const triangleSurface& s,
    const std::vector<vector>& points
)
{
    const polygonMesh mesh = makeMesh(s);
    const CGAL::Side_of_triangle_mesh<polygonMesh, kernel> side(mesh);
    std::vector<int> result;
    for (const vector& p : points)
    {
        const CGAL::Bounded_side where = side(kernel::Point_3(p.x, p.y, p.z));
        result.push_back
        (
            where == CGAL::ON_BOUNDED_SIDE ? 1
          : where == CGAL::ON_BOUNDARY ? 0
          : -1
        );
    }
    return result;
}

} // namespace gpuFsi
