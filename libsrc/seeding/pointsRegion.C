#include "seeding/pointsRegion.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace gpuFsi
{

pointsRegion::pointsRegion(const regionInput& input)
:
    implicitRegion(input, false),
    nNearest_(input.dimensions == 2 ? 4 : 8)
{
    const std::filesystem::path file = input.dict.get<std::string>("file");
    const std::filesystem::path full = input.casePath/file;
    if (!std::filesystem::is_regular_file(full))
    {
        throw userError
        (
            "Cannot find file " + full.string(),
            input.dict.where("file"),
            "The path is relative to the case."
        );
    }
    read(full, input.dimensions);
    for (const surfacePoint& p : points_)
    {
        positions_.push_back(p.position);
    }
    nearest_ = std::make_unique<nearestPoints>(positions_);
}


void pointsRegion::read(const std::filesystem::path& file, int dimensions)
{
    std::ifstream in(file);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number)
    {
        const auto fail = [&](const std::string& what)
        {
            throw userError
            (
                what,
                {file.string(), number, number},
                "A line holds x y z nx ny nz and, on all lines or none, an"
                " area; # begins a comment."
            );
        };
        std::istringstream words(line.substr(0, line.find('#')));
        std::vector<double> values;
        for (std::string word; words >> word; )
        {
            char* end = nullptr;
            values.push_back(std::strtod(word.c_str(), &end));
            if (*end || !std::isfinite(values.back()))
            {
                fail("'" + word + "' is not a finite number");
            }
        }
        if (values.empty())
        {
            continue;
        }
        if (values.size() != 6 && values.size() != 7)
        {
            fail(fmt::format("Found {} numbers", values.size()));
        }
        surfacePoint p
        {
            {values[0], values[1], values[2]},
            {values[3], values[4], values[5]},
            values.size() == 7 ? values[6] : 0
        };
        if (dimensions == 2)
        {
            p.position.z = p.normal.z = 0;
        }
        const double length = magnitude(p.normal);
        if (!(length > 0) || !std::isfinite(length))
        {
            fail("The normal has no length");
        }
        if (values.size() == 7 && !(p.area > 0))
        {
            fail(fmt::format("The area {} is not positive", p.area));
        }
        if (!points_.empty() && (p.area > 0) != (points_[0].area > 0))
        {
            fail("Some points have an area and others have none");
        }
        p.normal = (1/length)*p.normal;
        points_.push_back(p);
    }
    if (points_.empty())
    {
        throw userError
        (
            "No points in " + file.string(),
            {file.string(), 0, 0},
            "Give lines of x y z nx ny nz."
        );
    }
}


double pointsRegion::phi(const vector& p) const
{
    nearest_->find(p, std::min(nNearest_, points_.size()), found_);
    double sum = 0;
    double weights = 0;
    for (const auto& [d2, i] : found_)
    {
        if (d2 == 0)
        {
            return 0;
        }
        // Relative to the nearest: no overflow however near
        const double ratio = found_.front().first/d2;
        const double weight = ratio*ratio;
        sum += weight*dot(positions_[i] - p, points_[i].normal);
        weights += weight;
    }
    // Normals point into the fluid whichever side that is
    return (fluidInside() ? 1 : -1)*sum/weights;
}


std::optional<box> pointsRegion::bounds() const
{
    box b{positions_[0], positions_[0]};
    for (const vector& p : positions_)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            double& low = component(b.first, axis);
            double& high = component(b.second, axis);
            low = std::min(low, component(p, axis));
            high = std::max(high, component(p, axis));
        }
    }
    return b;
}


std::string pointsRegion::description() const
{
    return fmt::format("{} points", points_.size()) + sideText();
}


regionTrace pointsRegion::trace(const lattice& l) const
{
    regionTrace result = implicitRegion::trace(l);
    result.points = points_;
    return result;
}

} // namespace gpuFsi
