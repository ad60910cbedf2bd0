#include "ui/widgets/look_names.hpp"

#include "engine/base/translation.hpp"

namespace zeroset::ui {

const char* shown_name(Look look) {
    switch (look) {
        case Look::Standard: return tr("Standard");
        case Look::Phong: return tr("Phong");
        case Look::Matte: return tr("Matte");
        case Look::Porcelain: return tr("Porcelain");
        case Look::Metal: return tr("Metal");
        case Look::Glass: return tr("Glass");
        case Look::Clay: return tr("Clay");
        case Look::Technical: return tr("Technical");
    }
    return "";
}

}  // namespace zeroset::ui
