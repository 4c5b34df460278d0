#include <sphonic/kernel_card.hpp>
#include <sphonic/shown.hpp>

namespace sphonic {
namespace {

Panel empty(const std::string& title, const std::string& x, const std::string& y) {
    Panel panel;
    panel.title = title;
    panel.x.label = x;
    panel.y.label = y;
    return panel;
}

Panel transforms_panel() {
    Panel panel = empty("Fourier transform", "k h [rad]", "W(k)/W(0)");
    panel.curves.push_back({.label = "", .x = {0, 16}, .y = {0, 0}, .style = Curve::Style::dashed, .point_labels = {}});
    return panel;
}

Panel dispersion_panel(int dimension) {
    Panel panel = empty("Speed of waves, corrected weights, " + std::to_string(dimension) + "-D", "points per wavelength", "c/c0");
    panel.x.log = true;
    panel.curves.push_back({.label = "", .x = {2, 40}, .y = {1, 1}, .style = Curve::Style::dashed, .point_labels = {}});
    return panel;
}

Chart beside(const std::string& title, Panel left, Panel right) {
    return {.title = title, .panels = {std::move(left), std::move(right)}, .columns = 2, .width = 1500, .height = 600};
}

}    // namespace

Chart kernel_chart(const KernelCard& card) {
    Panel transforms = transforms_panel(), dispersion = dispersion_panel(card.dimensions.front());
    for (const KernelTransform& t : card.transforms)
        transforms.curves.push_back({.label = std::to_string(t.dimension) + "-D", .x = t.kh, .y = t.value, .point_labels = {}});
    for (const KernelDispersion& d : card.dispersion)
        dispersion.curves.push_back({.label = "h/dx = " + shown(d.h_over_dx, 3), .x = d.per_wavelength, .y = d.speed, .point_labels = {}});
    return beside("Kernel " + card.name, std::move(transforms), std::move(dispersion));
}

Chart kernel_comparison(const std::vector<KernelCard>& cards) {
    Panel transforms = transforms_panel(), dispersion = dispersion_panel(cards.front().dimensions.front());
    for (const KernelCard& card : cards) {
        const KernelTransform& t = card.transforms.front();
        transforms.curves.push_back({.label = card.name, .x = t.kh, .y = t.value, .point_labels = {}});
        const KernelDispersion& d = card.dispersion.front();
        dispersion.curves.push_back({.label = card.name + ", h/dx = " + shown(d.h_over_dx, 3), .x = d.per_wavelength, .y = d.speed, .point_labels = {}});
    }
    transforms.title += ", " + std::to_string(cards.front().dimensions.front()) + "-D";
    return beside("Kernels compared", std::move(transforms), std::move(dispersion));
}

}    // namespace sphonic
