#include "app/desktop/picture_feed.hpp"

#include "document/framing.hpp"
#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/field_source.hpp"

#include <utility>

namespace zeroset {
namespace {

/// The part of the colouring that needs a formula.
ColorChoice choice_of(const Document& document) {
    ColorChoice choice;
    choice.by = document.coloring.by;
    const LineChoice& lines = document.coloring.lines;
    if (lines.contours == Contours::Expression) {
        choice.lines.contours = lines.contours;
        choice.lines.expression = lines.expression;
    }
    if (choice.by == ColorBy::Expression) choice.expression = document.coloring.expression;
    return choice;
}

}  // namespace

PictureFeed::PictureFeed(std::function<void()> on_formula, std::function<void()> on_picture)
    : formulas_(std::move(on_formula)), pictures_(std::move(on_picture)) {}

void PictureFeed::read(const Document& document, bool draws_old) {
    Sheet sheet = sheet_of(document);
    const ColorChoice choice = choice_of(document);
    // Rows are read again in another language: their errors and notes are written in it; when
    // files may be read otherwise, when they are drawn stretched otherwise, or when what wrong rows
    // drew goes.
    const std::uint64_t files = document.files ? document.files->version() : 0;
    const glm::dvec3 stretch = stretch_of(document);
    const bool told_otherwise = given_.language != language() || given_.files != files ||
                                given_.source != document.files || given_.stretch != stretch ||
                                (given_.draws_old && !draws_old);
    if (sheet == given_.rows && choice == given_.choice && !told_otherwise) return;
    if (told_otherwise) answered_ = {};
    given_ = {.rows = sheet,
              .choice = choice,
              .stretch = stretch,
              .language = language(),
              .files = files,
              .source = document.files,
              .draws_old = draws_old};
    formulas_.submit(std::move(sheet), {document.clip, stretch}, choice, document.files, draws_old);
}

std::optional<FormulaResult> PictureFeed::take_reading() {
    std::optional<FormulaResult> result = formulas_.take();
    if (!result) return std::nullopt;
    answered_ = {.rows = result->sheet,
                 .choice = result->choice,
                 .language = given_.language,
                 .files = given_.files,
                 .source = given_.source};
    if (result->formula) adopt(*result);
    return result;
}

void PictureFeed::adopt(const FormulaResult& result) {
    const std::shared_ptr<const Formula>& formula = *result.formula;
    // For the same text, the formula that is drawn may have more code already.
    const bool same = formula_ != nullptr && same_functions(*formula_, *formula) &&
                      formula_->surface_rows == formula->surface_rows &&
                      formula_->files == formula->files &&
                      (formula_->code == formula->code || formula->code != CodeState::Machine);
    if (!same) formula_ = formula;
    colors_ = result.colors;
}

void PictureFeed::take_double() {
    std::shared_ptr<const Formula> formula = formulas_.take_double();
    if (formula == nullptr || deepening_ != formula_) return;
    deepening_.reset();
    formula_ = std::move(formula);
}

bool PictureFeed::has_read(const Document& document) const {
    return answered_.rows == sheet_of(document) && answered_.choice == given_.choice;
}

std::optional<PictureRequest> PictureFeed::wanted(const Document& document,
                                                  const TraceSettings& settings,
                                                  glm::ivec2 size_px) const {
    if (formula_ == nullptr || colors_ == nullptr || !document.camera || size_px.x <= 0 ||
        size_px.y <= 0) {
        return std::nullopt;
    }
    TraceSettings of_document = settings;
    of_document.stop = document.stop;
    PictureRequest request = picture_request(formula_, colors_, document, of_document, size_px);
    request.camera =
        fitting(request.camera, static_cast<double>(size_px.x) / static_cast<double>(size_px.y));
    return request;
}

bool PictureFeed::submit(PictureRequest wanted) {
    if (submitted_ == wanted) return false;
    if (!has_code_for(wanted)) {
        // The last picture stays until the code in this precision is ready.
        if (!deepens()) formulas_.submit_double(formula_);
        deepening_ = formula_;
        return false;
    }
    RenderRequest request = render_request(wanted);
    request.preview = is_preview(*formula_);
    request.again = submitted_ && differs_in_code_only(*submitted_, wanted);
    newest_ = pictures_.submit(std::move(request));
    submitted_ = std::move(wanted);
    return true;
}

void PictureFeed::note_shown(const RenderResult& result) {
    shown_.request = result.request;
    shown_.full = result.complete;
    if (shows_newest()) {
        shown_.text = submitted_->formula->text;
        formulas_.drawn();
    }
    if (shown_.full) shown_.figures_text = shown_.text;
}

const PictureRequest* PictureFeed::on_screen() const {
    return submitted_ && shows_newest() ? &*submitted_ : nullptr;
}

bool PictureFeed::drawn() const {
    if (formula_ == nullptr) return true;
    return submitted_ && !tracing() && !deepens() && !is_preview(*formula_);
}

WaitNotice::Causes PictureFeed::waits_for() const {
    WaitNotice::Causes causes;
    causes.reading = reads();
    causes.picture = reads() || (formula_ != nullptr && formula_->text != shown_.text);
    causes.figures = reads() || (formula_ != nullptr && formula_->text != shown_.figures_text);
    const bool compiles = formula_ != nullptr && formula_->code == CodeState::InterpretedFirst;
    causes.code = !reads() && (compiles || deepens());
    if (causes.code) causes.nodes = formula_->nodes();
    return causes;
}

}  // namespace zeroset
