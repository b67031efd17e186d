#include "views/panels/seampricelist.h"

#include "views/panels/controls.h"
#include "views/ui/numbertext.h"
#include "views/ui/reasons.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

enum Column { Edges, Length, Without };
constexpr int listHeight = 130; // device-independent pixels, room for five seams

} // namespace

SeamPriceList::SeamPriceList(QWidget *parent)
    : QWidget(parent), mList(new QTreeWidget), mPrice(makeButton(tr("Price seams"), "priceSeams"_L1)),
      mDrop(makeButton(tr("Drop"), "dropSeam"_L1)), mNextDrop(makeButton(tr("Best to drop"), "nextDrop"_L1)),
      mNextAdd(makeButton(tr("Best to add"), "nextAdd"_L1)), mRemark(makeRemark())
{
    mList->setObjectName("seamPrices"_L1);
    mList->setHeaderLabels({tr("Edges"), tr("Saves"), tr("D without")});
    mList->headerItem()->setToolTip(
        Length, tr("Length that the seams lose without it, on the mesh scaled to area π"));
    mList->headerItem()->setToolTip(Without,
                                    tr("Distortion of the map without it; – where it cannot be closed"));
    mList->setRootIsDecorated(false);
    mList->setUniformRowHeights(true);
    mList->setMinimumHeight(listHeight);
    mList->header()->setSectionResizeMode(QHeaderView::Stretch);
    mRemark->setObjectName("priceRemark"_L1);
    mPrice->setToolTip(tr("Measure what the distortion would be without each seam; with given seams, without "
                          "each of these"));
    mDrop->setToolTip(tr("Join the edges of the seam, so that it is no seam any more (Delete)"));
    mNextDrop->setToolTip(tr("Select the seam whose loss adds the least distortion per length"));
    mNextAdd->setToolTip(tr("Cut the new seam that lowers the distortion most per length"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing);
    layout->addWidget(makeRow({mPrice, mDrop}));
    layout->addWidget(mList);
    layout->addWidget(mRemark);
    layout->addWidget(makeRow({mNextDrop, mNextAdd}));
    auto *remove = new QShortcut(QKeySequence(Qt::Key_Delete), mList);
    remove->setContext(Qt::WidgetShortcut);
    connect(remove, &QShortcut::activated, this, &SeamPriceList::dropCurrent);
    connect(mPrice, &QPushButton::clicked, this, &SeamPriceList::pricesWanted);
    connect(mDrop, &QPushButton::clicked, this, &SeamPriceList::dropCurrent);
    connect(mNextDrop, &QPushButton::clicked, this, &SeamPriceList::proposeDrop);
    connect(mNextAdd, &QPushButton::clicked, this, &SeamPriceList::proposeAdd);
    connect(mList, &QTreeWidget::currentItemChanged, this, [this] {
        showChoice();
        if (const unwrap::SeamPrice *price = current())
            Q_EMIT picked(price->edges);
    });
    setPrices(nullptr, 0);
}

void SeamPriceList::setPrices(const unwrap::SeamPrices *prices, double maxDistortion)
{
    const QSignalBlocker blocker(mList);
    mPrices = prices ? *prices : unwrap::SeamPrices();
    mList->clear();
    for (const unwrap::SeamPrice &price : mPrices.seams) {
        auto *item = new QTreeWidgetItem(mList);
        item->setText(Edges, countText(static_cast<qint64>(price.edges.size())));
        item->setText(Length, price.distortion ? fixedText(price.length, 3) : missingText());
        item->setText(Without, price.distortion ? fixedText(*price.distortion, 4) : missingText());
        for (const Column column : {Edges, Length, Without})
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        QFont font = item->font(Without);
        font.setBold(price.distortion && *price.distortion <= maxDistortion);
        item->setFont(Without, font);
        item->setToolTip(Without,
                         font.bold() ? tr("The map stays within its bound without this seam") : QString());
    }
    if (!prices)
        mRemark->setText(tr("Not priced since the last change of the map."));
    else if (const std::optional<unwrap::SeamPrice> &best = prices->proposal)
        mRemark->setText(tr("D is %1; one more seam of %2 would make it %3.")
                             .arg(fixedText(prices->distortion, 4), fixedText(best->length, 3),
                                  fixedText(*best->distortion, 4)));
    else
        mRemark->setText(
            tr("D is %1; no further seam would lower it.").arg(fixedText(prices->distortion, 4)));
    showChoice();
}

void SeamPriceList::setCanPrice(bool can)
{
    enableOrSay(mPrice, can, tr("There is no map yet, or a job is running"));
}

const unwrap::SeamPrice *SeamPriceList::current() const
{
    const int row = mList->currentIndex().row();
    return row >= 0 && row < static_cast<int>(mPrices.seams.size()) ? &mPrices.seams[row] : nullptr;
}

void SeamPriceList::showChoice()
{
    const unwrap::SeamPrice *price = current();
    enableOrSay(mDrop, price && price->distortion, tr("Choose a seam of the list that can be closed"));
    enableOrSay(mNextDrop, !mPrices.seams.empty() && mPrices.seams.front().distortion,
                tr("Price the seams first"));
    enableOrSay(mNextAdd, mPrices.proposal.has_value(), tr("No new seam is known: price the seams first"));
}

void SeamPriceList::dropCurrent()
{
    if (const unwrap::SeamPrice *price = current(); price && price->distortion)
        Q_EMIT dropped(price->edges);
}

//! The list is sorted by it.
void SeamPriceList::proposeDrop()
{
    mList->setCurrentItem(mList->topLevelItem(0));
    mList->setFocus();
}

void SeamPriceList::proposeAdd()
{
    if (mPrices.proposal)
        Q_EMIT added(mPrices.proposal->edges);
}

} // namespace autocuts
