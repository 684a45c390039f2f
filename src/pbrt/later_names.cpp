#include "pbrt/later_names.h"

#include <algorithm>
#include <map>
#include <utility>

namespace drc::pbrt {

void LaterNames::finish() {
    while (!waiting_.empty()) {
        std::vector<Waiting> still;
        std::vector<UndefinedName> reasons;
        const size_t before = waiting_.size();
        for (Waiting& w : std::exchange(waiting_, {})) {
            try {
                w.make();
            } catch (const UndefinedName& reason) {
                reasons.push_back(reason);
                still.push_back(std::move(w));
            }
        }
        if (still.size() == before) failStuck(still, reasons);
        waiting_ = std::move(still);
    }
}

void LaterNames::failStuck(const std::vector<Waiting>& stuck, const std::vector<UndefinedName>& reasons) {
    std::map<std::pair<std::string, std::string>, size_t> byName;
    for (size_t i = 0; i < stuck.size(); ++i) byName[{stuck[i].kind, stuck[i].name}] = i;
    for (const UndefinedName& reason : reasons)
        if (!byName.contains({reason.kind, reason.name})) throw reason;
    // Each of these waits for another one, so following the references leads into a cycle.
    std::vector<size_t> way;
    for (size_t at = 0;; at = byName.at({reasons[at].kind, reasons[at].name})) {
        const auto before = std::find(way.begin(), way.end(), at);
        if (before == way.end()) {
            way.push_back(at);
            continue;
        }
        std::string circle;
        for (auto i = before; i != way.end(); ++i) circle += "'" + stuck[*i].name + "' uses ";
        fail(reasons[at].pos, "the " + stuck[at].kind + " '" + stuck[at].name + "' is made of itself: " + circle + "'" +
                                  stuck[at].name + "'");
    }
}

}  // namespace drc::pbrt
