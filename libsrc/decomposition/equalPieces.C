#include "decomposition/equalPieces.H"

#include "base/error.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

class cutter
{
public:

    cutter(const std::vector<double>& weights, int n)
    :
        n_(n),
        sum_(weights.size() + 1, 0),
        some_(weights.size() + 1, 0)
    {
        for (std::size_t i = 0; i < weights.size(); ++i)
        {
            sum_[i + 1] = sum_[i] + weights[i];
            some_[i + 1] = some_[i] + (weights[i] > 0);
        }
        cap_ = leastCap();
    }

    std::vector<std::size_t> bounds() const
    {
        const std::vector<std::size_t> earliest = earliestEnds();
        std::vector<std::size_t> b(n_ + 1, 0);
        for (int k = 0; k < n_; ++k)
        {
            b[k + 1] = k + 1 < n_ ? end(b[k], n_ - k, earliest[k]) : items();
        }
        return b;
    }

private:

    std::size_t items() const { return sum_.size() - 1; }

    //- Furthest end of a piece from `start` that weighs at most `cap`
    std::size_t furthest(std::size_t start, double cap) const
    {
        const auto beyond = std::partition_point
        (
            sum_.begin() + start,
            sum_.end(),
            [&](double s) { return s - sum_[start] <= cap; }
        );
        return beyond - sum_.begin() - 1;
    }

    bool fits(double cap) const
    {
        std::size_t at = 0;
        for (int k = 0; k < n_; ++k)
        {
            at = furthest(at, cap);
        }
        return at == items();
    }

    //- Weight of the heaviest piece at best, by bisection
    double leastCap() const
    {
        double low = sum_.back()/n_;
        for (std::size_t i = 0; i < items(); ++i)
        {
            low = std::max(low, sum_[i + 1] - sum_[i]);
        }
        if (fits(low))
        {
            return low;
        }
        double high = sum_.back();
        for (int i = 0; i < 60; ++i)
        {
            const double middle = 0.5*(low + high);
            (fits(middle) ? high : low) = middle;
        }
        return high;
    }

    //- Ends of the pieces when each takes its all from the back
    std::vector<std::size_t> earliestEnds() const
    {
        std::vector<std::size_t> ends(n_, items());
        for (int k = n_ - 1; k > 0; --k)
        {
            const double whole = sum_[ends[k]];
            ends[k - 1] = std::partition_point
            (
                sum_.begin(),
                sum_.begin() + ends[k],
                [&](double s) { return whole - s > cap_; }
            ) - sum_.begin();
        }
        return ends;
    }

    //- End of the piece from `start`, the first of `left` pieces
    std::size_t end
    (
        std::size_t start,
        int left,
        std::size_t earliest
    ) const
    {
        std::size_t low = std::max(start, earliest);
        std::size_t high = furthest(start, cap_);
        const int to = some_.back() - some_[start];
        if (to > 0)
        {
            low = std::max(low, endOfItems(some_[start] + 1));
        }
        if (to >= left)
        {
            high = std::min(high, endOfItems(some_.back() - left + 2) - 1);
        }
        low = std::min(low, high);
        const double even =
            sum_[start] + (sum_.back() - sum_[start])/left;
        const auto from = sum_.begin();
        const std::size_t above =
            std::lower_bound(from + low, from + high, even) - from;
        return above > low && even - sum_[above - 1] <= sum_[above] - even
          ? above - 1 : above;
    }

    //- Least end with so many items of weight before it
    std::size_t endOfItems(int count) const
    {
        return std::lower_bound(some_.begin(), some_.end(), count)
          - some_.begin();
    }

    const int n_;
    std::vector<double> sum_;     // of the weights before an item
    std::vector<int> some_;       // number of items with weight before it
    double cap_;
};

} // namespace


std::vector<std::size_t> equalPieces
(
    const std::vector<double>& weights,
    int n
)
{
    developerAssert(n > 0, "at least one piece");
    const bool none = std::none_of
    (
        weights.begin(), weights.end(), [](double w) { return w > 0; }
    );
    return cutter
    (
        none ? std::vector<double>(weights.size(), 1) : weights, n
    ).bounds();
}

} // namespace gpuFsi
