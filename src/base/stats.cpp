#include "base/stats.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace drc {
namespace {

std::vector<std::string> split(const std::string& name) {
    std::vector<std::string> parts;
    std::istringstream in(name);
    for (std::string part; std::getline(in, part, '/');) parts.push_back(part);
    if (parts.empty()) parts.push_back(name);
    return parts;
}

// Groups digits by thousands: 1234567 -> "1,234,567".
std::string grouped(int64_t n) {
    const std::string digits = fmt::format("{}", n);
    const size_t sign = n < 0 ? 1 : 0;
    std::string text;
    for (size_t i = 0; i < digits.size(); ++i) {
        if (i > sign && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

struct Row {
    std::string name, value, note;
};

bool isTimer(const nlohmann::json& value) { return value.size() == 2 && value.contains("calls"); }

void addRows(const nlohmann::json& group, int depth, std::vector<Row>& rows) {
    for (const auto& [key, value] : group.items()) {
        const std::string name = std::string(size_t(2 * depth), ' ') + key;
        if (value.is_number()) {
            rows.push_back({name, grouped(value.get<int64_t>()), ""});
        } else if (isTimer(value)) {
            rows.push_back({name, fmt::format("{:.3f}", value["seconds"].get<double>()),
                            fmt::format(" s, {} calls", grouped(value["calls"].get<int64_t>()))});
        } else {
            rows.push_back({name, "", ""});
            addRows(value, depth + 1, rows);
        }
    }
}

void place(nlohmann::json& root, const std::string& name, nlohmann::json value) {
    nlohmann::json* at = &root;
    for (const auto& part : split(name)) {
        if (!at->is_null() && (!at->is_object() || isTimer(*at))) *at = {{"total", *at}};
        at = &(*at)[part];
    }
    if (at->is_null())
        *at = std::move(value);
    else
        (*at)["total"] = std::move(value);
}

}  // namespace

size_t Counter::shard() {
    static std::atomic<size_t> threads{0};
    static thread_local const size_t mine = threads.fetch_add(1, std::memory_order_relaxed) % kShards;
    return mine;
}

int64_t Counter::count() const {
    int64_t sum = 0;
    for (const auto& s : shards_) sum += s.value.load(std::memory_order_relaxed);
    return sum;
}

Counter& Stats::counter(const std::string& name) {
    const std::lock_guard lock(mutex_);
    return counters_[name];
}

Timer& Stats::timer(const std::string& name) {
    const std::lock_guard lock(mutex_);
    return timers_[name];
}

int64_t Stats::count(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    const auto it = counters_.find(name);
    return it == counters_.end() ? 0 : it->second.count();
}

double Stats::seconds(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    const auto it = timers_.find(name);
    return it == timers_.end() ? 0 : it->second.seconds();
}

std::string Stats::json() const {
    const std::lock_guard lock(mutex_);
    nlohmann::json root = nlohmann::json::object();
    for (const auto& [name, counter] : counters_) place(root, name, counter.count());
    for (const auto& [name, timer] : timers_) {
        place(root, name, {{"seconds", timer.seconds()}, {"calls", timer.calls()}});
    }
    return root.dump(2);
}

std::string Stats::report() const {
    std::vector<Row> rows;
    addRows(nlohmann::json::parse(json()), 0, rows);
    size_t nameWidth = 0, valueWidth = 0;
    for (const auto& r : rows) {
        nameWidth = std::max(nameWidth, r.name.size());
        valueWidth = std::max(valueWidth, r.value.size());
    }
    std::string table;
    for (const auto& r : rows) {
        if (r.value.empty())
            table += r.name + "\n";
        else
            table += fmt::format("{:<{}}  {:>{}}{}\n", r.name, nameWidth, r.value, valueWidth, r.note);
    }
    return table;
}

}  // namespace drc
