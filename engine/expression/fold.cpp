#include "engine/core/at.h"
#include "engine/expression/evaluate.h"
#include "engine/expression/measure.h"

namespace pinfield {
namespace {

class Folding {
public:
    Folding(const Expression& from, std::vector<Measure> measures) : from_(from), measures_(std::move(measures)) {
        out_.text = from.text;
        out_.names = from.names;
        for (const ExpressionNode& node : from.nodes) {
            bool constant = node.operation != Operation::name;
            if (constant)
                for (const int operand : node.operands) constant = constant && (operand < 0 || at(constant_, operand));
            constant_.push_back(constant);
        }
    }

    Expression run() && {
        copy(from_.root());
        return std::move(out_);
    }

private:
    int copy(int index) {
        ExpressionNode node = at(from_.nodes, index);
        const Measure& measure = at(measures_, index);
        if (at(constant_, index) && !measure.condition && node.operation != Operation::literal) {
            expressions::Evaluation<double> evaluation(from_, {});
            const double value = evaluation.number(index);
            if (evaluation.fault() < 0) node = {Operation::literal, {-1, -1, -1}, value, measure, node.span};
        }
        if (node.operation != Operation::name)
            for (int& operand : node.operands)
                if (operand >= 0) operand = copy(operand);
        out_.nodes.push_back(node);
        return out_.root();
    }

    const Expression& from_;
    std::vector<Measure> measures_;
    std::vector<bool> constant_;
    Expression out_;
};

}  // namespace

Expression folded(const Expression& expression, std::span<const Measure> names) {
    auto measures = measures_of(expression, names);
    if (!measures) return expression;
    return Folding(expression, std::move(*measures)).run();
}

}  // namespace pinfield
