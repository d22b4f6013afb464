#include "chart/html_report.h"

#include <fmt/format.h>

#include "base/xml_text.h"
#include "chart/svg_text.h"

namespace tetralux::chart {
namespace {

constexpr std::string_view kStyle = R"(
:root{color-scheme:light dark}
body{font:15px/1.5 system-ui,"DejaVu Sans",sans-serif;color:#24292f;background:#fff;margin:2em auto;max-width:1120px;padding:0 1em}
h1{font-size:1.7em;margin:0 0 .4em}h2{font-size:1.3em;margin:2em 0 .5em;padding-top:.6em;border-top:1px solid #d0d7de}
h3{font-size:1.05em;margin:1.6em 0 .4em}
pre{background:#f6f8fa;padding:.7em 1em;overflow-x:auto;border-radius:6px;font-size:13px}
figure.chart{margin:1em 0}figure.chart svg{max-width:100%;height:auto;display:block}
.scroll{overflow-x:auto}table{border-collapse:collapse;font-size:12px;font-variant-numeric:tabular-nums;margin:.6em 0}
th,td{padding:.22em .42em;text-align:right;white-space:nowrap;border-bottom:1px solid #e3e7eb}
th{border-bottom:2px solid #8c959f;vertical-align:bottom}td.t,th.t{text-align:left}
tr.s td{font-weight:700;background:#ddf4ff}tbody tr:hover td{background:#f6f8fa}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(296px,1fr));gap:1.1em}
.pictures figure{margin:0;font-size:12px}.pictures .pair{display:flex;gap:4px}
.pictures img{width:calc(50% - 2px);height:auto;image-rendering:pixelated;background:#000;display:block}
.pictures span{width:calc(50% - 2px);align-self:center;text-align:center;color:#8c959f}
.pictures b{font-weight:600;font-size:13px}.pictures b.s::after{content:" \2605"}
@media(prefers-color-scheme:dark){body{color:#e6edf3;background:#0d1117}h2{border-color:#30363d}pre{background:#161b22}
th,td{border-color:#30363d}tr.s td{background:#12283f}tbody tr:hover td{background:#161b22}}
)";

}  // namespace

HtmlReport::HtmlReport(std::string_view title) {
  html_ = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>{0}</title>\n"
      "<style>{1}</style></head>\n<body>\n<h1>{0}</h1>\n",
      escapedXml(title), kStyle);
}

void HtmlReport::heading(std::string_view text) { html_ += fmt::format("<h2>{}</h2>\n", escapedXml(text)); }
void HtmlReport::subheading(std::string_view text) { html_ += fmt::format("<h3>{}</h3>\n", escapedXml(text)); }
void HtmlReport::paragraph(std::string_view text) { html_ += fmt::format("<p>{}</p>\n", escapedXml(text)); }
void HtmlReport::code(std::string_view text) { html_ += fmt::format("<pre>{}</pre>\n", escapedXml(text)); }
void HtmlReport::chart(std::string_view svg) { html_ += fmt::format("<figure class=\"chart\">{}</figure>\n", svg); }

void HtmlReport::table(const ReportTable& table) {
  const auto row = [&](const std::vector<std::string>& cells, const char* tag, bool isStrong) {
    html_ += isStrong ? "<tr class=\"s\">" : "<tr>";
    for (size_t i = 0; i < cells.size(); i++)
      html_ += fmt::format("<{0}{1}>{2}</{0}>", tag, i < table.textColumns ? " class=\"t\"" : "", escapedXml(cells[i]));
    html_ += "</tr>\n";
  };
  html_ += "<div class=\"scroll\"><table><thead>";
  row(table.header, "th", false);
  html_ += "</thead><tbody>\n";
  for (size_t i = 0; i < table.rows.size(); i++)
    row(table.rows[i], "td", i < table.isStrong.size() && table.isStrong[i]);
  html_ += "</tbody></table></div>\n";
}

void HtmlReport::pictures(const std::vector<ReportPicture>& pictures) {
  html_ += "<div class=\"pictures\">\n";
  for (const ReportPicture& picture : pictures) {
    html_ += fmt::format("<figure><b{}>{}</b><div class=\"pair\">", picture.isStrong ? " class=\"s\"" : "",
                         escapedXml(picture.caption));
    html_ += picture.pictureUri.empty()
                 ? "<span>looks like the exact one</span>"
                 : fmt::format("<img alt=\"{}\" src=\"{}\">", escapedXml(picture.caption), picture.pictureUri);
    if (!picture.differenceUri.empty())
      html_ +=
          fmt::format("<img alt=\"difference of {}\" src=\"{}\">", escapedXml(picture.caption), picture.differenceUri);
    html_ += fmt::format("</div>{}</figure>\n", escapedXml(picture.note));
  }
  html_ += "</div>\n";
}

std::string HtmlReport::finish() && {
  html_ += "</body></html>\n";
  return std::move(html_);
}

}  // namespace tetralux::chart
