// A report in one HTML file that needs nothing beside it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tetralux::chart {

struct ReportTable {
  std::vector<std::string> header;
  size_t textColumns = 1;  // the first ones, aligned left; the others are numbers
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> isStrong;  // per row; may be empty
};

struct ReportPicture {
  std::string caption;        // above it
  std::string pictureUri;     // data URI
  std::string differenceUri;  // may be empty
  std::string note;           // below it
  bool isStrong = false;
};

// Builds the page from the top. Texts are plain; they are escaped here. SVG is put in as it is.
class HtmlReport {
 public:
  explicit HtmlReport(std::string_view title);

  void heading(std::string_view text);     // of a part
  void subheading(std::string_view text);  // within it
  void paragraph(std::string_view text);
  void code(std::string_view text);
  void chart(std::string_view svg);
  void table(const ReportTable& table);
  void pictures(const std::vector<ReportPicture>& pictures);

  std::string finish() &&;

 private:
  std::string html_;
};

}  // namespace tetralux::chart
