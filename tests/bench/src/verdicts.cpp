#include "verdicts.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "numbers.h"

namespace chebnet::bench {
namespace {

// In the order of a reader, not of the alphabet.
using Json = nlohmann::ordered_json;

Json value_json(const Value& value, const Figure& figure) {
    const auto variant = std::ranges::find(figure.variants, value.variant, &Variant::name);
    Json json;
    if (variant != figure.variants.end()) json["variant"] = variant - figure.variants.begin();
    json["value"] = std::isfinite(value.value) ? Json(std::stod(formatted("%.4g", value.value))) : Json(nullptr);
    json["unit"] = value.unit;
    return json;
}

Json claim_json(const Verdict& verdict, const Figure& figure) {
    Json json{{"verdict", verdict.word()}, {"held", verdict.held()}, {"asked", verdict.outcomes.size()}};
    json["values"] = Json::array();
    for (const Value& value : verdict.outcomes.front().values) json["values"].push_back(value_json(value, figure));
    return json;
}

}  // namespace

int Verdict::held() const { return static_cast<int>(std::ranges::count_if(outcomes, &Outcome::holds)); }

const char* Verdict::word() const {
    if (held() == static_cast<int>(outcomes.size())) return "holds";
    return held() == 0 ? "does not hold" : "differs";
}

std::vector<Verdict> judge(const Result& result) {
    std::vector<Verdict> verdicts;
    for (const Claim& claim : result.figure->claims) {
        Verdict verdict{&claim, &find_check(claim.check), {}};
        for (const Group& group : result.groups) verdict.outcomes.push_back(verdict.check->ask(group));
        verdicts.push_back(std::move(verdict));
    }
    return verdicts;
}

std::string verdicts_json(const std::vector<Result>& results) {
    Json json;
    for (const Result& result : results) {
        Json claims = Json::array();
        for (const Verdict& verdict : judge(result)) claims.push_back(claim_json(verdict, *result.figure));
        json[result.figure->name] = {{"claims", std::move(claims)}};
    }
    return json.dump(1) + '\n';
}

std::string verdicts_table(const std::vector<Result>& results) {
    std::string table = "| of the paper | claim | verdict | true of | on the first edit |\n|---|---|---|---|---|\n";
    for (const Result& result : results)
        for (const Verdict& verdict : judge(result))
            table += "| " + result.figure->place() + " | " + verdict.claim->text + " | **" + verdict.word() + "** | " +
                     std::to_string(verdict.held()) + " of " + std::to_string(verdict.outcomes.size()) + " | " +
                     to_words(verdict.outcomes.front().values, result.groups.front()) + " |\n";
    return table;
}

}  // namespace chebnet::bench
