#include "study/picture.H"

#include "study/gnuplot.H"

#include <algorithm>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

//- Legible on white, also without red and green; then over again
const char* const colours[] =
{
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
    "#332288", "#7a5195", "#882255", "#117733"
};
constexpr int nColours = 10;
const int marks[] = {7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14};
constexpr int nMarks = 12;

//- Labels of the study's own resolutions, in order of appearance
std::vector<std::string> resolutionsOf(const std::vector<curve>& curves)
{
    std::vector<std::string> labels;
    for (const curve& c : curves)
    {
        for (const curvePoint& p : c.points)
        {
            if (!c.compared && std::find(labels.begin(), labels.end(),
                p.resolution) == labels.end())
            {
                labels.push_back(p.resolution);
            }
        }
    }
    return labels;
}


std::string rowOf(const curvePoint& p, int mark)
{
    return fmt::format
    (
        "{:.9g} {:.9g} {:.9g} {:.9g} {}\n", p.seconds.median, p.error,
        p.seconds.least, p.seconds.greatest, mark
    );
}


//- Points in order of their run time, as a block of data
std::string blockOf
(
    const std::string& name,
    std::vector<curvePoint> points
)
{
    std::stable_sort(points.begin(), points.end(), [](auto& a, auto& b)
    {
        return a.seconds.median < b.seconds.median;
    });
    std::string text = name + " << EOD\n";
    for (const curvePoint& p : points)
    {
        text += rowOf(p, 0);
    }
    return text + "EOD\n";
}


class script
{
public:

    script(const std::vector<curve>& curves, const std::string& title)
    :
        curves_(curves),
        title_(title),
        labels_(resolutionsOf(curves))
    {}

    //- Data, and the parts of the plot command in the order of painting
    void compose(const std::string& resolutionName)
    {
        addFront();
        addIso();
        addCurves();
        for (std::size_t i = 0; i < labels_.size(); ++i)
        {
            parts_ += fmt::format
            (
                ", \\\n  keyentry with points pt {} lc rgb '#555555' title {}",
                marks[i % nMarks],
                gnuplotText(resolutionName + " " + labels_[i])
            );
        }
    }

    const std::string& data() const { return data_; }
    const std::string& parts() const { return parts_; }

private:

    void addFront()
    {
        std::vector<curvePoint> front;
        for (const curve& c : curves_)
        {
            for (const curvePoint& p : c.points)
            {
                if (p.pareto)
                {
                    front.push_back(p);
                }
            }
        }
        data_ += blockOf("$front", front);
        parts_ += "$front using 1:2 with lines lw 9 lc rgb '#dddddd' "
            "title 'Pareto front'";
    }

    void addIso()
    {
        for (std::size_t i = 0; i < labels_.size(); ++i)
        {
            std::vector<curvePoint> same;
            for (const curve& c : curves_)
            {
                for (const curvePoint& p : c.points)
                {
                    if (!c.compared && p.resolution == labels_[i])
                    {
                        same.push_back(p);
                    }
                }
            }
            const std::string name = fmt::format("$iso{}", i);
            data_ += blockOf(name, same);
            parts_ += ", \\\n  " + name + " using 1:2 with lines lw 0.7 dt 3 "
                "lc rgb '#999999' notitle";
        }
    }

    int markOf(const curve& c, const curvePoint& p) const
    {
        const auto found =
            std::find(labels_.begin(), labels_.end(), p.resolution);
        return c.compared && found == labels_.end()
          ? 2 : marks[(found - labels_.begin()) % nMarks];
    }

    //- A study's only curve has the title, which stands above, as its name
    std::string legendOf(const curve& c) const
    {
        return !c.compared && c.name == title_ ? "this study" : c.name;
    }

    void addCurves()
    {
        for (std::size_t i = 0; i < curves_.size(); ++i)
        {
            const curve& c = curves_[i];
            const std::string name = fmt::format("$curve{}", i);
            data_ += name + " << EOD\n";
            for (const curvePoint& p : c.points)
            {
                data_ += rowOf(p, markOf(c, p));
            }
            data_ += "EOD\n";
            const char* colour = colours[i % nColours];
            parts_ += fmt::format
            (
                ", \\\n  {0} using 1:2 with lines lw 1.6 dt {1} lc rgb '{2}' "
                "title {3}"
                ", \\\n  {0} using 1:2:3:4 with xerrorbars pt 0 lw 1 "
                "lc rgb '{2}' notitle"
                ", \\\n  {0} using 1:2:5 with points pt variable ps 1 "
                "lc rgb '{2}' notitle",
                name, c.compared || i >= nColours ? 2 : 1, colour,
                gnuplotText(legendOf(c))
            );
        }
    }

    const std::vector<curve>& curves_;
    const std::string& title_;
    std::vector<std::string> labels_;
    std::string data_, parts_;
};

} // namespace


std::string gnuplotOf
(
    const std::vector<curve>& curves,
    const std::string& stem,
    const std::string& title,
    const std::string& xLabel,
    const std::string& yLabel,
    const std::string& resolutionName
)
{
    script s(curves, title);
    s.compose(resolutionName);
    std::string text = fmt::format
    (
        "{}set logscale xy\nset format xy '10^{{%L}}'\nset grid lt 1 "
        "lc rgb '#eeeeee'\nset key outside right top samplen 2 spacing 1.2\n"
        "set title {}\nset xlabel {}\nset ylabel {}\n",
        s.data(), gnuplotText(title), gnuplotText(xLabel), gnuplotText(yLabel)
    );
    const char* terminals[][2] =
    {
        {"svg", "svg size 1000,620 font 'sans,13' background '#ffffff'"},
        {"png", "pngcairo size 1000,620 font 'sans,11'"}
    };
    for (const auto& [ending, terminal] : terminals)
    {
        text += fmt::format
        (
            "set terminal {}\nset output {}\nplot {}\n", terminal,
            "'" + stem + "." + ending + "'", s.parts()
        );
    }
    return text;
}

} // namespace gpuFsi
