#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "sphonic/chart.hpp"
#include "sphonic/error.hpp"

namespace sphonic {

std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error) {
    if (cost.size() != error.size())
        throw Error(Fault::input, "Pareto front",
                    std::to_string(cost.size()) + " costs for " + std::to_string(error.size()) + " errors",
                    "Give one cost and one error per point");
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < cost.size(); ++i)
        if (std::isfinite(cost[i]) && std::isfinite(error[i])) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(cost[i], error[i], i); });

    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        const bool better = front.empty() || error[i] < error[front.back()];
        const bool equal = !front.empty() && error[i] == error[front.back()] && cost[i] == cost[front.back()];
        if (better || equal) front.push_back(i);
    }
    return front;
}

}    // namespace sphonic
