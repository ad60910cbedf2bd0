#pragma once

#include "app/desktop/wait_notice.hpp"
#include "document/document.hpp"
#include "document/sheet.hpp"
#include "engine/base/language.hpp"
#include "engine/render/render_job.hpp"
#include "engine/scene/settings.hpp"
#include "pipeline/color_formulas.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/formula_job.hpp"
#include "pipeline/picture_request.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace zeroset {

/// A document's pictures over time: the rows go to a FormulaJob, pictures of its newest formula to
/// a RenderJob. Knows what is read, what is drawn and what is on the screen, but no window. One
/// thread owns it; the jobs' threads only call the two functions.
///
///   read() -> take_reading() -> wanted(), submit() -> take_picture() -> note_shown()
class PictureFeed {
public:
    /// `on_formula` is called when take_reading() or take_double() has something new, `on_picture`
    /// when take_picture() has.
    PictureFeed(std::function<void()> on_formula, std::function<void()> on_picture);

    /// Has the document's rows and its colours read, unless that is done already. `draws_old`:
    /// whether what wrong rows drew before stays, see SheetReader::read.
    void read(const Document& document, bool draws_old = true);
    /// The newest reading not yet taken. Its formula, if there is one, is drawn from now on.
    std::optional<FormulaResult> take_reading();
    /// Takes code in double for formula(), once it is there; nothing else changes.
    void take_double();
    /// True while rows are being read.
    [[nodiscard]] bool reads() const { return answered_.rows != given_.rows; }
    /// True if the newest reading is of the document's rows and of the colours given last.
    [[nodiscard]] bool has_read(const Document& document) const;
    /// The formula that is drawn; nullptr before the first.
    [[nodiscard]] const std::shared_ptr<const Formula>& formula() const { return formula_; }
    /// The colours made for formula(), which must be there.
    [[nodiscard]] const ColorFormulas& colors() const { return *colors_; }

    /// The document's picture by formula(); nothing without a formula, a camera or pixels.
    [[nodiscard]] std::optional<PictureRequest> wanted(const Document& document,
                                                       const TraceSettings& settings,
                                                       glm::ivec2 size_px) const;
    /// Has a picture from wanted() drawn; true if that begins. It does not if it was asked for
    /// last, or while its precision needs code that is then being made.
    bool submit(PictureRequest wanted);
    /// The newest picture not yet taken.
    std::optional<RenderResult> take_picture() { return pictures_.take(); }
    /// Says that a picture from take_picture() is on the screen.
    void note_shown(const RenderResult& result);

    /// Number of the newest request; 0: none.
    [[nodiscard]] std::uint64_t newest() const { return newest_; }
    /// True while the newest request's full picture is still to come.
    [[nodiscard]] bool tracing() const { return newest_ != 0 && !(shows_newest() && shown_.full); }
    /// True if the picture on the screen is of the newest request, fine or coarse.
    [[nodiscard]] bool shows_newest() const { return shown_.request == newest_; }
    /// The request of the picture on the screen; nullptr if a newer one is on its way.
    [[nodiscard]] const PictureRequest* on_screen() const;
    /// True if no better picture of formula() will come: full, by its last code. True without one.
    [[nodiscard]] bool drawn() const;
    /// Causes for which one who looks at the screen waits.
    [[nodiscard]] WaitNotice::Causes waits_for() const;

private:
    /// Rows and colours, of which a formula is made.
    struct Text {
        std::optional<Sheet> rows;
        ColorChoice choice;
        glm::dvec3 stretch{1.0};                              ///< of the document
        Language language = Language::English;                ///< of what is told of them
        std::uint64_t files = 0;                              ///< FieldSource::version() then
        std::shared_ptr<const FieldSource> source = nullptr;  ///< the document's
        bool draws_old = true;
    };
    /// The picture on the screen.
    struct OnScreen {
        std::uint64_t request = 0;
        bool full = false;
        std::string text;          ///< of its formula
        std::string figures_text;  ///< of the last full picture's formula
    };

    void adopt(const FormulaResult& result);
    /// True while formula() waits for code in double.
    [[nodiscard]] bool deepens() const { return formula_ != nullptr && deepening_ == formula_; }

    Text given_;     ///< to be read
    Text answered_;  ///< by the newest reading
    std::shared_ptr<const Formula> formula_;
    std::shared_ptr<const ColorFormulas> colors_;
    std::shared_ptr<const Formula> deepening_;  ///< for which code in double was asked last
    std::optional<PictureRequest> submitted_;
    std::uint64_t newest_ = 0;
    OnScreen shown_;
    FormulaJob formulas_;
    RenderJob pictures_;
};

}  // namespace zeroset
