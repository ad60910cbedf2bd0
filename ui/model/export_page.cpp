#include "ui/model/export_page.hpp"

namespace zeroset::ui {

std::string ending_of(const ExportFormat& format) {
    return (format.numbered ? "####" : "") + std::string(format.ending);
}

}  // namespace zeroset::ui
