#include "plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "markup.h"

namespace chebnet::bench {
namespace {

// Okabe & Ito's palette, told apart by the colour-blind, less black and yellow, which need a certain background. The
// second time round, lines are dashed.
constexpr std::array k_colours = {"#D55E00", "#0072B2", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
constexpr const char* k_ink = "#808080";  // as far from white as from black

constexpr double k_width = 420, k_height = 260;                                // of a panel with its labels
constexpr double k_left = 62, k_right = 24, k_top = 30, k_bottom = 46;         // of these, around the axes
constexpr double k_legend_line = 20, k_legend_entry = 210, k_legend_top = 14;  // px

std::string px(double value) { return formatted("%.1f", value); }

std::string text_at(double x, double y, const std::string& text, const char* attributes) {
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" " + attributes + ">" + escaped(text) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, double opacity) {
    return "<line x1=\"" + px(x1) + "\" y1=\"" + px(y1) + "\" x2=\"" + px(x2) + "\" y2=\"" + px(y2) + "\" stroke=\"" +
           k_ink + "\" opacity=\"" + formatted("%g", opacity) + "\"/>\n";
}

/// From values to pixels, with round ticks. A logarithmic axis counts in powers of ten.
class Axis {
public:
    Axis(bool is_log, double first_px, double last_px) : m_is_log(is_log), m_first_px(first_px), m_last_px(last_px) {}

    bool shows(double value) const { return std::isfinite(value) && (!m_is_log || value > 0); }
    void include(double value) {
        m_low = std::min(m_low, scaled(value));
        m_high = std::max(m_high, scaled(value));
    }
    /// Widens the range to whole ticks.
    void finish() {
        if (m_low > m_high) m_low = 0, m_high = 1;
        m_step = m_is_log ? std::max(1.0, std::ceil((m_high - m_low) / 8)) : round_step((m_high - m_low) / 5);
        m_low = std::floor(m_low / m_step + 1e-9) * m_step;
        m_high = std::max(m_low + m_step, std::ceil(m_high / m_step - 1e-9) * m_step);
    }
    double operator()(double value) const { return place(scaled(value)); }

    struct Tick {
        double at;
        std::string label;
    };
    std::vector<Tick> ticks() const {
        std::vector<Tick> list;
        for (double s = m_low; s < m_high + m_step / 2; s += m_step)
            list.push_back({place(s), m_is_log ? power_label(s) : formatted("%g", std::abs(s) < m_step / 2 ? 0 : s)});
        return list;
    }

private:
    static std::string power_label(double exponent) {
        return exponent >= 0 && exponent <= 5 ? formatted("%g", std::pow(10, exponent)) : formatted("1e%g", exponent);
    }
    static double round_step(double rough) {
        if (rough <= 0) return 1;
        const double power = std::pow(10, std::floor(std::log10(rough)));
        for (const double factor : {1.0, 2.0, 5.0})
            if (factor * power >= rough) return factor * power;
        return 10 * power;
    }
    double scaled(double value) const { return m_is_log ? std::log10(value) : value; }
    double place(double s) const { return m_first_px + (s - m_low) / (m_high - m_low) * (m_last_px - m_first_px); }

    bool m_is_log;
    double m_first_px, m_last_px;
    double m_low = std::numeric_limits<double>::infinity(), m_high = -m_low, m_step = 1;
};

std::vector<std::string> legend_keys(const std::vector<Panel>& panels) {
    std::vector<std::string> keys;
    for (const Panel& panel : panels)
        for (const Series& series : panel.series)
            if (std::ranges::find(keys, series.key) == keys.end()) keys.push_back(series.key);
    return keys;
}

std::string stroke(std::size_t key) {
    const bool dashed = key >= k_colours.size();
    return std::string("stroke=\"") + k_colours[key % k_colours.size()] + "\" stroke-width=\"2\" fill=\"none\"" +
           (dashed ? " stroke-dasharray=\"6 3\"" : "");
}

std::string curve(const Series& series, std::size_t key, const Axis& x, const Axis& y) {
    std::string path, dots;
    const bool few = series.points.size() <= 30;
    for (const Point& point : series.points) {
        if (!x.shows(point.x) || !y.shows(point.y)) continue;
        const std::string at_x = px(x(point.x)), at_y = px(y(point.y));
        path += (path.empty() ? "M" : " L") + at_x + " " + at_y;
        if (few)
            dots += "<circle cx=\"" + at_x + "\" cy=\"" + at_y + "\" r=\"2.5\" fill=\"" +
                    k_colours[key % k_colours.size()] + "\"/>\n";
    }
    for (const Point& circle : series.circles)
        if (x.shows(circle.x) && y.shows(circle.y))
            dots += "<circle cx=\"" + px(x(circle.x)) + "\" cy=\"" + px(y(circle.y)) +
                    "\" r=\"6\" stroke-width=\"1.5\" stroke=\"" + k_ink + "\" fill=\"none\"/>\n";
    return "<path d=\"" + path + "\" " + stroke(key) + "/>\n" + dots;
}

std::string dotted_line(double x) {
    return "<line x1=\"" + px(x) + "\" y1=\"" + px(k_top) + "\" x2=\"" + px(x) + "\" y2=\"" + px(k_height - k_bottom) +
           "\" stroke=\"" + k_ink + "\" stroke-width=\"1.5\" stroke-dasharray=\"2 4\"/>\n";
}

std::string axes(const Axis& x, const Axis& y, const Panel& panel) {
    const double right = k_width - k_right, bottom = k_height - k_bottom;
    std::string svg;
    for (const auto& [at, label] : x.ticks()) {
        svg += line(at, k_top, at, bottom, 0.2);
        svg += text_at(at, bottom + 16, label, "text-anchor=\"middle\"");
    }
    for (const auto& [at, label] : y.ticks()) {
        svg += line(k_left, at, right, at, 0.2);
        svg += text_at(k_left - 6, at + 4, label, "text-anchor=\"end\"");
    }
    svg += line(k_left, bottom, right, bottom, 1) + line(k_left, k_top, k_left, bottom, 1);
    svg += text_at((k_left + right) / 2, bottom + 34, panel.x_label, "text-anchor=\"middle\"");
    const std::string turn = "text-anchor=\"middle\" transform=\"rotate(-90 14 " + px((k_top + bottom) / 2) + ")\"";
    svg += text_at(14, (k_top + bottom) / 2, panel.y_label, turn.c_str());
    return svg + text_at(k_left, k_top - 10, panel.title, "font-weight=\"bold\"");
}

std::string draw(const Panel& panel, const std::vector<std::string>& keys) {
    Axis x(panel.log_x, k_left, k_width - k_right), y(panel.log_y, k_height - k_bottom, k_top);
    for (const Series& series : panel.series)
        for (const Point& point : series.points)
            if (x.shows(point.x) && y.shows(point.y)) x.include(point.x), y.include(point.y);
    x.finish();
    y.finish();
    std::string svg = axes(x, y, panel);
    for (const double at : panel.lines) svg += dotted_line(x(at));
    for (const Series& series : panel.series)
        svg += curve(series, static_cast<std::size_t>(std::ranges::find(keys, series.key) - keys.begin()), x, y);
    return svg;
}

std::string legend(const std::vector<std::string>& keys, int per_line) {
    std::string svg;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const double x = k_left + static_cast<double>(i % per_line) * k_legend_entry;
        const double y = k_legend_top + static_cast<double>(i / per_line) * k_legend_line;
        svg += "<path d=\"M" + px(x) + " " + px(y) + " h22\" " + stroke(i) + "/>\n";
        svg += text_at(x + 28, y + 4, keys[i], "");
    }
    return svg;
}

}  // namespace

std::string to_svg(const std::vector<Panel>& panels, int columns) {
    const auto keys = legend_keys(panels);
    const int count = static_cast<int>(panels.size());
    const double width = columns * k_width;
    const int per_line = std::max(1, static_cast<int>((width - k_left) / k_legend_entry));
    const double legend_height = k_legend_line * std::ceil(static_cast<double>(keys.size()) / per_line) + 10;
    const double height = legend_height + k_height * ((count + columns - 1) / columns);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + px(width) + " " + px(height) +
                      "\" width=\"" + px(width) + "\" height=\"" + px(height) +
                      "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"" + k_ink + "\">\n" +
                      legend(keys, per_line);
    for (int i = 0; i < count; ++i)
        svg += "<g transform=\"translate(" + px(i % columns * k_width) + " " +
               px(legend_height + i / columns * k_height) + ")\">\n" + draw(panels[static_cast<std::size_t>(i)], keys) +
               "</g>\n";
    return svg + "</svg>\n";
}

}  // namespace chebnet::bench
