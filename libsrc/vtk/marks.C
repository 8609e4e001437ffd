#include "vtk/marks.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

markedScene collect
(
    const std::vector<cloud>& clouds,
    const shownField& field,
    const std::optional<cutPlane>& plane,
    double spacing,
    const pictureOptions& options
)
{
    const auto shown = [&](const vector& p)
    {
        if (plane)
        {
            const double c =
                plane->axis == 0 ? p.x : plane->axis == 1 ? p.y : p.z;
            if (std::abs(c - plane->value) > 0.8*spacing)
            {
                return false;
            }
        }
        return !options.keep || options.keep(p);
    };

    markedScene scene;
    bool any = false;
    for (const cloud& from : clouds)
    {
        const cloudField* values = field.in(from);
        for (std::size_t i = 0; i < from.size(); ++i)
        {
            if (!shown(from.positions[i]))
            {
                continue;
            }
            const double value = values ? field.value(*values, i) : 0;
            scene.marks.push_back
            (
                {from.positions[i], value, values != nullptr}
            );
            if (values)
            {
                scene.lowest = any ? std::min(scene.lowest, value) : value;
                scene.highest = any ? std::max(scene.highest, value) : value;
                any = true;
            }
        }
    }

    if (options.range)
    {
        scene.range = *options.range;
    }
    else if (scene.highest > scene.lowest)
    {
        scene.range = {scene.lowest, scene.highest};
    }
    else
    {
        // One value everywhere takes the middle colour
        const double half =
            scene.lowest == 0 ? 1 : 0.05*std::abs(scene.lowest);
        scene.range = {scene.lowest - half, scene.lowest + half};
    }
    return scene;
}

} // namespace gpuFsi
