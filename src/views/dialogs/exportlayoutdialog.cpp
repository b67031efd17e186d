#include "views/dialogs/exportlayoutdialog.h"

#include "views/dialogs/pathfield.h"
#include "views/ui/colorbutton.h"
#include "views/ui/questions.h"
#include "views/ui/reasons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>

namespace autocuts {

namespace {

// Limits from LayoutOptions.
constexpr int minSize = 16, maxSize = 16384, maxBleed = 256;

} // namespace

ExportLayoutDialog::ExportLayoutDialog(int size, const QString &path, std::vector<int> overlapping,
                                       Questions &questions)
    : QDialog(questions.window()), mOverlapping(std::move(overlapping)), mFormat(new QComboBox),
      mBackground(new QComboBox), mPart(new QComboBox), mSize(new QSpinBox), mBleed(new QSpinBox),
      mFill(new QCheckBox(tr("F&ill the islands"))), mEdges(new QCheckBox(tr("&Edges inside the islands"))),
      mSeams(new QCheckBox(tr("O&utlines of the islands"))), mOverlaps(new QCheckBox(tr("Hatch &overlaps"))),
      mPath(new PathField(tr("Export layout"), questions)), mProblem(new QLabel)
{
    setWindowTitle(tr("Export layout"));
    mFormat->addItem(tr("PNG, to paint over"), QStringLiteral("png"));
    mFormat->addItem(tr("SVG, to print or edit"), QStringLiteral("svg"));
    mBackground->addItem(tr("Transparent"), int(LayoutBackground::Transparent));
    mBackground->addItem(tr("Dark"), int(LayoutBackground::Dark));
    mBackground->addItem(tr("Light"), int(LayoutBackground::Light));
    const LayoutOptions defaults;
    mBackground->setCurrentIndex(mBackground->findData(int(defaults.background)));
    mSize->setRange(minSize, maxSize);
    mSize->setSuffix(tr(" px"));
    mSize->setToolTip(tr("Pixels along the longer side; the picture has the shape of the texture"));
    mSize->setValue(std::clamp(size, minSize, maxSize));
    mBleed->setObjectName(QStringLiteral("bleed"));
    mBleed->setRange(0, maxBleed);
    mBleed->setSuffix(tr(" px"));
    mBleed->setToolTip(tr("How far the fill of an island goes on beyond its outline; it never covers another "
                          "island"));
    mFill->setChecked(defaults.fill);
    mEdges->setChecked(defaults.edges);
    mSeams->setChecked(defaults.seams);
    connect(mFill, &QCheckBox::toggled, mBleed,
            [this](bool fills) { enableOrSay(mBleed, fills, tr("Only filled islands bleed")); });
    mOverlaps->setObjectName(QStringLiteral("overlaps"));
    enableOrSay(mOverlaps, !mOverlapping.empty(), tr("The map has no overlaps, or was not measured yet"));
    mOverlaps->setChecked(!mOverlapping.empty());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    mExport = buttons->addButton(tr("E&xport"), QDialogButtonBox::AcceptRole);
    mExport->setDefault(true);
    auto *form = new QFormLayout(this);
    form->addRow(tr("&Format:"), mFormat);
    form->addRow(tr("&Size:"), mSize);
    form->addRow(tr("Back&ground:"), mBackground);
    mPart->setObjectName(QStringLiteral("part"));
    offerParts(false, false);
    form->addRow(tr("&Part:"), mPart);
    form->addRow(tr("&Bleed:"), mBleed);
    form->addRow(QString(), mFill);
    form->addRow(QString(), mEdges);
    form->addRow(QString(), mSeams);
    form->addRow(QString(), mOverlaps);
    form->addRow(tr("Own colours:"), makeColors());
    form->addRow(tr("Fi&le:"), mPath);
    form->addRow(QString(), mProblem);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportLayoutDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &ExportLayoutDialog::reject);
    connect(mFormat, &QComboBox::currentIndexChanged, this, &ExportLayoutDialog::showFormat);
    connect(mPath, &PathField::pathChanged, this, &ExportLayoutDialog::showPath);
    mPath->setPath(path);
    showFormat();
}

ExportLayoutDialog::OwnColor ExportLayoutDialog::makeColor(const QString &text, const QString &name,
                                                           const QColor &first)
{
    const OwnColor color{new QCheckBox(text), new ColorButton(text)};
    color.box->setObjectName(name);
    color.button->setColor(first);
    const auto show = [=, why = tr("Tick the box beside it first")](bool on) {
        enableOrSay(color.button, on, why);
    };
    connect(color.box, &QCheckBox::toggled, color.button, show);
    show(false);
    return color;
}

QWidget *ExportLayoutDialog::makeColors()
{
    mIslandColor = makeColor(tr("Isla&nds"), QStringLiteral("islandColor"), QColor(0x80, 0x80, 0x80));
    mEdgeColor = makeColor(tr("E&dges"), QStringLiteral("edgeColor"), Qt::black);
    mSeamColor = makeColor(tr("Ou&tlines"), QStringLiteral("seamColor"), Qt::white);
    auto *box = new QWidget;
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    int row = 0;
    for (const OwnColor &color : {mIslandColor, mEdgeColor, mSeamColor}) {
        grid->addWidget(color.box, row, 0);
        grid->addWidget(color.button, row++, 1);
    }
    return box;
}

std::optional<QColor> ExportLayoutDialog::chosen(const OwnColor &color)
{
    return color.box->isChecked() ? std::optional(color.button->color()) : std::nullopt;
}

void ExportLayoutDialog::offerParts(bool hidden, bool selected)
{
    mPart->clear();
    mPart->addItem(tr("The whole map"), int(LayoutPart::All));
    if (hidden)
        mPart->addItem(tr("What is shown"), int(LayoutPart::Shown));
    if (selected)
        mPart->addItem(tr("The selected faces"), int(LayoutPart::Selected));
    enableOrSay(mPart, mPart->count() > 1, tr("Nothing is hidden, and no face is selected"));
}

LayoutPart ExportLayoutDialog::part() const
{
    return LayoutPart(mPart->currentData().toInt());
}

QString ExportLayoutDialog::path() const
{
    return mPath->path();
}

LayoutOptions ExportLayoutDialog::options() const
{
    LayoutOptions options;
    options.size = mSize->value();
    options.fill = mFill->isChecked();
    options.edges = mEdges->isChecked();
    options.seams = mSeams->isChecked();
    options.bleed = mBleed->value();
    options.islandColor = chosen(mIslandColor);
    options.edgeColor = chosen(mEdgeColor);
    options.seamColor = chosen(mSeamColor);
    options.background = LayoutBackground(mBackground->currentData().toInt());
    if (mOverlaps->isChecked())
        options.overlapping = mOverlapping;
    return options;
}

void ExportLayoutDialog::showFormat()
{
    const QString suffix = mFormat->currentData().toString();
    mPath->setFilters(
        {suffix == QLatin1String("png") ? tr("PNG picture (*.png)") : tr("SVG drawing (*.svg)")});
    mPath->setSuffix(suffix);
    showPath();
}

//! A typed suffix sets the format.
void ExportLayoutDialog::showPath()
{
    const int index = mFormat->findData(QFileInfo(path()).suffix().toLower());
    QString problem = mPath->problem();
    if (problem.isEmpty() && index < 0)
        problem = tr("The suffix must be .png or .svg.");
    if (index >= 0)
        mFormat->setCurrentIndex(index);
    mProblem->setText(problem);
    disableFor(problem, mExport);
}

void ExportLayoutDialog::accept()
{
    if (mExport->isEnabled() && mPath->confirmReplacing())
        QDialog::accept();
}

} // namespace autocuts
