#include "algorithms/refinement/formula.hpp"

#include "algorithms/abandon.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace tribunal::refinement {
namespace {
using Operation = Formula::Operation;

struct Function {
  std::string_view name;
  Operation operation;
  int arguments;
};
constexpr std::array functions{
    Function{"sqrt", Operation::sqrt, 1},   Function{"abs", Operation::abs, 1},
    Function{"exp", Operation::exp, 1},     Function{"log", Operation::log, 1},
    Function{"sin", Operation::sin, 1},     Function{"cos", Operation::cos, 1},
    Function{"tan", Operation::tan, 1},     Function{"tanh", Operation::tanh, 1},
    Function{"atan2", Operation::atan2, 2}, Function{"hypot", Operation::hypot, 2},
    Function{"min", Operation::min, 2},     Function{"max", Operation::max, 2},
};

/// Where a unary operation stands before its operand, above what a product may hold back.
constexpr int unary_binding = 3;
int binding(Operation operation) {
  switch (operation) {
    case Operation::add:
    case Operation::subtract:
      return 1;
    case Operation::multiply:
    case Operation::divide:
      return 2;
    case Operation::negate:
      return unary_binding;
    default:
      return 4;
  }
}

/// Dijkstra's shunting yard: operators wait on a stack until one that binds less comes.
class Parser {
 public:
  Parser(std::string_view text, std::span<const std::string_view> variables)
      : text_(text), variables_(variables) {}

  std::vector<Formula::Instruction> run() {
    for (skip_spaces(); at_ < text_.size(); skip_spaces()) {
      if (operand_expected_)
        read_operand();
      else
        read_operator();
    }
    if (operand_expected_) refuse("a value is missing");
    pop_to(std::nullopt);
    if (!waiting_.empty()) refuse("a parenthesis is not closed");
    return std::move(program_);
  }

 private:
  /// An operator, or an opening parenthesis, after the name of a function or not.
  struct Waiting {
    std::optional<Operation> operation;  // none: a parenthesis
    const Function* function = nullptr;  // of the parenthesis
    int commas = 0;
  };

  [[noreturn]] void refuse(const std::string& reason) const {
    throw Abandon(Outcome::refused_input, "formula \"" + std::string(text_) + "\", column " +
                                              std::to_string(at_ + 1) + ": " + reason);
  }
  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void read_operand() {
    if (take('(')) {
      waiting_.push_back({});
    } else if (take('-')) {
      waiting_.push_back({Operation::negate});
    } else if (!read_name()) {
      double number = 0;
      const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
      if (error != std::errc{} || !std::isfinite(number)) refuse("a value is expected");
      at_ = static_cast<std::size_t>(end - text_.data());
      program_.push_back({Operation::number, 0, number});
      operand_expected_ = false;
    }
  }

  bool read_name() {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t end = at_;
    while (end < text_.size() && (letter(text_[end]) || (end > at_ && digit(text_[end])))) ++end;
    if (end == at_) return false;
    const std::string_view name = text_.substr(at_, end - at_);
    const auto function =
        std::find_if(functions.begin(), functions.end(), [&](const Function& f) { return f.name == name; });
    const auto variable = std::find(variables_.begin(), variables_.end(), name);
    if (function == functions.end() && variable == variables_.end() && name != "pi")
      refuse("there is no \"" + std::string(name) + "\"");
    at_ = end;
    if (variable != variables_.end()) {
      program_.push_back({Operation::variable, static_cast<std::uint32_t>(variable - variables_.begin())});
      operand_expected_ = false;
    } else if (name == "pi") {
      program_.push_back({Operation::number, 0, std::numbers::pi});
      operand_expected_ = false;
    } else {
      skip_spaces();
      if (!take('(')) refuse("a parenthesis is expected after " + std::string(name));
      waiting_.push_back({std::nullopt, &*function});
    }
    return true;
  }

  void read_operator() {
    constexpr std::string_view symbols = "+-*/^";
    constexpr std::array operations{Operation::add, Operation::subtract, Operation::multiply,
                                    Operation::divide, Operation::power};
    if (take(',')) {
      pop_to(std::nullopt);
      if (waiting_.empty() || waiting_.back().function == nullptr) refuse("a comma separates nothing");
      ++waiting_.back().commas;
      operand_expected_ = true;
    } else if (take(')')) {
      close();
    } else if (const auto symbol = symbols.find(text_[at_]); symbol != std::string_view::npos) {
      ++at_;
      pop_to(operations[symbol]);
      waiting_.push_back({operations[symbol]});
      operand_expected_ = true;
    } else {
      refuse("an operator is expected");
    }
  }

  void close() {
    pop_to(std::nullopt);
    if (waiting_.empty()) refuse("a parenthesis closes nothing");
    const Waiting open = waiting_.back();
    waiting_.pop_back();
    if (open.function == nullptr) return;
    if (open.commas + 1 != open.function->arguments)
      refuse(std::string(open.function->name) + " takes " + std::to_string(open.function->arguments) +
             (open.function->arguments == 1 ? " argument" : " arguments"));
    program_.push_back({open.function->operation});
  }

  /// Lets those go that bind at least as tightly as the operator that comes, or all up to a parenthesis.
  /// Powers associate to the right.
  void pop_to(std::optional<Operation> coming) {
    while (!waiting_.empty() && waiting_.back().operation) {
      const int held = binding(*waiting_.back().operation);
      if (coming && (held < binding(*coming) || (held == binding(*coming) && *coming == Operation::power)))
        return;
      program_.push_back({*waiting_.back().operation});
      waiting_.pop_back();
    }
  }

  std::string_view text_;
  std::span<const std::string_view> variables_;
  std::size_t at_ = 0;
  bool operand_expected_ = true;
  std::vector<Waiting> waiting_;
  std::vector<Formula::Instruction> program_;
};

double apply(Operation operation, double a) {
  switch (operation) {
    case Operation::negate:
      return -a;
    case Operation::sqrt:
      return std::sqrt(a);
    case Operation::abs:
      return std::fabs(a);
    case Operation::exp:
      return std::exp(a);
    case Operation::log:
      return std::log(a);
    case Operation::sin:
      return std::sin(a);
    case Operation::cos:
      return std::cos(a);
    case Operation::tan:
      return std::tan(a);
    default:
      return std::tanh(a);
  }
}

double apply(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      return a / b;
    case Operation::power:
      return std::pow(a, b);
    case Operation::atan2:
      return std::atan2(a, b);
    case Operation::hypot:
      return std::hypot(a, b);
    case Operation::min:
      return std::fmin(a, b);
    default:
      return std::fmax(a, b);
  }
}

bool takes_two(Operation operation) {
  switch (operation) {
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::divide:
    case Operation::power:
    case Operation::atan2:
    case Operation::hypot:
    case Operation::min:
    case Operation::max:
      return true;
    default:
      return false;
  }
}

}  // namespace

Formula::Formula(std::string_view text, std::span<const std::string_view> variables)
    : program_(Parser(text, variables).run()) {}

bool Formula::is_constant() const {
  return std::none_of(program_.begin(), program_.end(),
                      [](const Instruction& step) { return step.operation == Operation::variable; });
}

double Formula::operator()(std::span<const double> values) const {
  std::vector<double> stack;
  stack.reserve(program_.size());
  for (const Instruction& step : program_) {
    if (step.operation == Operation::number) {
      stack.push_back(step.number);
    } else if (step.operation == Operation::variable) {
      stack.push_back(values[step.variable]);
    } else if (takes_two(step.operation)) {
      const double second = stack.back();
      stack.pop_back();
      stack.back() = apply(step.operation, stack.back(), second);
    } else {
      stack.back() = apply(step.operation, stack.back());
    }
  }
  return stack.back();
}

}  // namespace tribunal::refinement
