// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/may_leave.h"

#include <llvm/Support/MathExtras.h>

#include <algorithm>
#include <optional>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_calls.h"
#include "facts/syntax/message_type.h"
#include "facts/syntax/package_types.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

std::optional<unsigned> bits_of(const Unit& unit, const clang::Expr* expr);

/// Bits of a sum, product, quotient, ... of numbers that are not negative; none: it may be.
std::optional<unsigned> bits_of(const Unit& unit, const clang::BinaryOperator* op) {
  const std::optional<unsigned> left = bits_of(unit, op->getLHS()), right = bits_of(unit, op->getRHS());
  if (!left || !right) return {};
  switch (op->getOpcode()) {
    case clang::BO_Add:
      return std::max(*left, *right) + 1;
    case clang::BO_Mul:
      return *left + *right;
    case clang::BO_Div:
    case clang::BO_Shr:
      return left;
    case clang::BO_Rem:
    case clang::BO_And:
      return std::min(*left, *right);
    default:
      return {};
  }
}

/// What a container has lies in memory, of which a machine addresses less than 2^47 bytes.
bool is_size_of_container(const clang::Expr* expr) {
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr);
  const clang::CXXMethodDecl* method = call ? call->getMethodDecl() : nullptr;
  if (!method || !method->getIdentifier()) return false;
  const bool is_container =
      method->getParent()->isInStdNamespace() || qualified_name_of(method->getParent()) == "pcl::PointCloud";
  return is_container && (method->getName() == "size" || method->getName() == "length");
}

/// How many bits a number has that is not negative, whatever its variables are; none: it may be negative.
std::optional<unsigned> bits_of(const Unit& unit, const clang::Expr* expr) {
  constexpr unsigned bits_of_memory = 47;
  clang::Expr::EvalResult known;
  expr = expr->IgnoreParens();
  if (!expr->getType()->isIntegerType() || expr->isValueDependent()) return {};
  if (expr->EvaluateAsInt(known, unit.ast()))
    return known.Val.getInt().isNegative() ? std::nullopt : std::optional(known.Val.getInt().getActiveBits());
  if (is_size_of_container(expr)) return bits_of_memory;
  std::optional<unsigned> bits;
  const auto* cast = llvm::dyn_cast<clang::CastExpr>(expr);
  if (cast && cast->getSubExpr()->getType()->isIntegerType()) bits = bits_of(unit, cast->getSubExpr());
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(expr)) bits = bits_of(unit, op);
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(expr)) {
    const auto one = bits_of(unit, choice->getTrueExpr()), other = bits_of(unit, choice->getFalseExpr());
    if (one && other) bits = std::max(*one, *other);
  }
  const auto width = static_cast<unsigned>(unit.ast().getIntWidth(expr->getType()));
  if (expr->getType()->isUnsignedIntegerType()) return std::min(bits.value_or(width), width);
  // A conversion to a narrower signed type may change the sign; a sum or product that does not fit has no behaviour.
  return bits && (!cast || *bits < width) ? std::optional(std::min(*bits, width - 1)) : std::nullopt;
}

/// Whether so many elements can be asked for without std::length_error: it is want of memory that speaks.
bool is_bounded(const Unit& unit, const clang::Expr* size, clang::QualType element) {
  constexpr unsigned bits_of_most = 62;
  if (element.isNull() || element->isDependentType() || element->isIncompleteType()) return false;
  const std::optional<unsigned> bits = bits_of(unit, size);
  const auto bytes = static_cast<std::uint64_t>(unit.ast().getTypeSizeInChars(element).getQuantity());
  return bits && *bits + llvm::Log2_64_Ceil(std::max<std::uint64_t>(bytes, 1)) <= bits_of_most;
}

bool is_zero(const Unit& unit, const clang::Expr* expr) {
  clang::Expr::EvalResult known;
  return !expr->isValueDependent() && expr->EvaluateAsInt(known, unit.ast()) && known.Val.getInt().isZero();
}

bool is_integer(const clang::Expr* expr) {
  return expr->getType()->isIntegerType();
}

llvm::StringRef name_of(const clang::FunctionDecl* function) {
  return function->getIdentifier() ? function->getName() : llvm::StringRef();
}

/// std::vector and its likes; null: it is none of their functions.
const clang::ClassTemplateSpecializationDecl* sequence_of(const clang::FunctionDecl* callee) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
  const clang::CXXRecordDecl* record = method ? method->getParent() : nullptr;
  if (!record || !record->isInStdNamespace() || !record->getIdentifier()) return nullptr;
  static constexpr llvm::StringRef sequences[] = {"vector", "deque", "list", "basic_string"};
  const bool is_one = llvm::is_contained(sequences, record->getName());
  return is_one ? llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record) : nullptr;
}

bool all_bounded(const Unit& unit, llvm::ArrayRef<const clang::Expr*> arguments, clang::QualType element) {
  return llvm::all_of(arguments, [&](const clang::Expr* argument) {
    return !is_integer(argument) || is_bounded(unit, argument, element);
  });
}

/// A string made from a null pointer throws.
bool is_text(const clang::Expr* argument) {
  const clang::Expr* given = argument->IgnoreParenImpCasts();
  return !argument->getType()->isPointerType() || llvm::isa<clang::StringLiteral>(given) ||
         (llvm::isa<clang::CXXMemberCallExpr>(given) &&
          name_of(llvm::cast<clang::CXXMemberCallExpr>(given)->getDirectCallee()) == "c_str");
}

/// s.substr(0, n), s.erase(0, n), s.insert(0, t): a position that every string has.
bool string_returns(const Unit& unit, const clang::FunctionDecl* callee,
                    llvm::ArrayRef<const clang::Expr*> arguments, clang::QualType element) {
  const llvm::StringRef name = name_of(callee);
  const bool begins_with_position = !arguments.empty() && is_integer(arguments[0]);
  if (name == "substr" || name == "erase") return !begins_with_position || is_zero(unit, arguments[0]);
  if (name == "compare") return arguments.size() == 1;
  if (name == "copy" || name == "at" || name == "replace") return false;
  if (name == "insert" && begins_with_position && !is_zero(unit, arguments[0])) return false;
  // string(t, position, n), append(t, position, n)
  const bool has_part = arguments.size() > 1 && arguments[0]->getType()->isRecordType() &&
                        is_integer(arguments[1]) && name != "insert";
  if (has_part) return is_zero(unit, arguments[1]);
  return all_bounded(unit, arguments, element) &&
         (!llvm::isa<clang::CXXConstructorDecl>(callee) || llvm::all_of(arguments, is_text));
}

/// A function that throws by what it is given. None: it is no such one.
std::optional<bool> sequence_returns(const Unit& unit, const clang::FunctionDecl* callee,
                                     llvm::ArrayRef<const clang::Expr*> arguments) {
  const clang::ClassTemplateSpecializationDecl* sequence = sequence_of(callee);
  if (!sequence || sequence->getTemplateArgs().size() == 0) return {};
  const llvm::StringRef name = name_of(callee);
  const clang::QualType element = sequence->getTemplateArgs()[0].getAsType();
  if (sequence->getName() == "basic_string") {
    static constexpr llvm::StringRef members[] = {"substr", "erase",   "compare", "copy",
                                                  "at",     "replace", "insert",  "append",
                                                  "assign", "resize",  "reserve"};
    if (llvm::isa<clang::CXXConstructorDecl>(callee) || llvm::is_contained(members, name))
      return string_returns(unit, callee, arguments, element);
    return {};
  }
  if (name == "emplace_back" || name == "emplace" || name == "emplace_front" || name == "at")
    return false;  // the arguments are those of some constructor
  const bool is_given_size = llvm::isa<clang::CXXConstructorDecl>(callee) || name == "resize" ||
                             name == "reserve" || name == "assign" || name == "insert";
  if (!is_given_size) return {};
  // Of insert(at, value), assign(n, value), vector(n, value) only n is a size.
  if (name == "insert" && arguments.size() < 3) return true;
  const std::size_t at = name == "insert" ? 1 : 0;
  return arguments.size() <= at || !is_integer(arguments[at]) || is_bounded(unit, arguments[at], element);
}

/// ros::Time(0), ros::Duration(0.1), ros::Time(a, 0): a constant that fits.
bool is_small_constant(const Unit& unit, const clang::Expr* argument) {
  constexpr double most = 2e9;
  clang::Expr::EvalResult known;
  if (argument->isValueDependent() || !argument->EvaluateAsRValue(known, unit.ast())) return false;
  if (known.Val.isInt()) return !known.Val.getInt().isNegative() && known.Val.getInt().getActiveBits() <= 30;
  return known.Val.isFloat() && known.Val.getFloat().convertToDouble() >= 0 &&
         known.Val.getFloat().convertToDouble() <= most;
}

bool is_time_constructor(const clang::FunctionDecl* callee) {
  if (!llvm::isa<clang::CXXConstructorDecl>(callee)) return false;
  const std::string name = qualified_name_of(llvm::cast<clang::CXXMethodDecl>(callee)->getParent());
  static constexpr llvm::StringRef times[] = {"ros::Time", "ros::Duration", "ros::WallTime",
                                              "ros::WallDuration"};
  return llvm::is_contained(times, llvm::StringRef(name));
}

/// Whether a stream is a local variable that the function only writes to and reads the text of, so that it never throws.
class OwnStream : public AstVisitor {
 public:
  OwnStream(const Unit& unit, const clang::VarDecl* stream) : unit_(unit), stream_(stream) {}
  bool is_plain = true;

  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    is_plain = is_plain && (reference->getDecl() != stream_ || writes_text(reference));
    return is_plain;
  }

 private:
  bool writes_text(const clang::Expr* mention) const {
    const auto* around = parent_as<clang::Expr>(unit_.ast(), *mention);
    static constexpr llvm::StringRef settings[] = {"str", "precision", "width", "fill", "setf", "unsetf"};
    if (mention->getType().isConstQualified()) return true;
    if (llvm::isa_and_nonnull<clang::ImplicitCastExpr>(around)) return writes_text(around);
    if (const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(around))
      return member->getMemberDecl()->getIdentifier()
                 ? llvm::is_contained(settings, member->getMemberDecl()->getName())
                 : writes_text(member);
    const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(around);
    const auto* call = llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(around);
    return call || (op && op->getOperator() == clang::OO_LessLess);
  }
  const Unit& unit_;
  const clang::VarDecl* stream_;
};

/// text << a << b into such a stream.
bool writes_to_own_stream(const Unit& unit, const clang::Expr* stream) {
  stream = stream->IgnoreParenImpCasts();
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(stream))
    return op->getOperator() == clang::OO_LessLess && writes_to_own_stream(unit, op->getArg(0));
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(stream);
  const auto* variable = name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr;
  const clang::CXXRecordDecl* record = variable ? variable->getType()->getAsCXXRecordDecl() : nullptr;
  if (!record || !record->isInStdNamespace() || !variable->hasLocalStorage() ||
      llvm::isa<clang::ParmVarDecl>(variable))
    return false;
  const clang::FunctionDecl* function = enclosing_function(unit.ast(), *name);
  if (!function || !function->getBody()) return false;
  OwnStream own(unit, variable);
  own.TraverseStmt(function->getBody());
  return own.is_plain;
}

bool is_stream_output(const clang::FunctionDecl* callee) {
  return callee->getOverloadedOperator() == clang::OO_LessLess &&
         callee->getReturnType()->isReferenceType() && qualified_name_of(callee).rfind("std::", 0) == 0;
}

bool is_noexcept(const clang::FunctionDecl* callee) {
  const auto* type = callee->getType()->getAs<clang::FunctionProtoType>();
  const auto spec = type ? type->getExceptionSpecType() : clang::EST_None;
  return spec == clang::EST_BasicNoexcept || spec == clang::EST_NoexceptTrue || spec == clang::EST_NoThrow ||
         spec == clang::EST_DynamicNone;
}

/// What the package gives a library may throw there: a comparison, a copy, a function. A closure of the function is followed.
bool brings_package(const Unit& unit, const clang::FunctionDecl* callee,
                    llvm::ArrayRef<const clang::Expr*> arguments) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
  if (method && involves_package(unit, unit.ast().getRecordType(method->getParent()))) return true;
  return llvm::any_of(arguments, [&](const clang::Expr* argument) {
    const clang::Expr* given = argument->IgnoreParenImpCasts();
    const clang::CXXRecordDecl* record = given->getType()->getAsCXXRecordDecl();
    const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(given);
    const auto* function = name ? llvm::dyn_cast<clang::FunctionDecl>(name->getDecl()) : nullptr;
    if (function) return unit.declares(function);  // text << std::fixed
    return !(record && record->isLambda()) && involves_package(unit, given->getType());
  });
}

/// make_shared<M>(...): of a message or a publisher, which are made and copied without exceptions.
bool makes_harmless(const clang::FunctionDecl* callee) {
  const clang::TemplateArgumentList* arguments = callee->getTemplateSpecializationArgs();
  if (!arguments || arguments->size() == 0 || (*arguments)[0].getKind() != clang::TemplateArgument::Type)
    return false;
  const clang::QualType type = (*arguments)[0].getAsType();
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return type->isArithmeticType() ||
         (record && (message_of(record) || is_publisher_class(qualified_name_of(record))));
}

bool returns_by_arguments(const Unit& unit, const clang::FunctionDecl* callee,
                          llvm::ArrayRef<const clang::Expr*> arguments) {
  if (const std::optional<bool> returns = sequence_returns(unit, callee, arguments)) return *returns;
  if (is_time_constructor(callee))
    return llvm::all_of(arguments, [&](const auto* argument) { return is_small_constant(unit, argument); });
  if (is_stream_output(callee) && !arguments.empty()) return writes_to_own_stream(unit, arguments[0]);
  const llvm::StringRef name = name_of(callee);
  if (name == "make_shared" || name == "make_unique") return makes_harmless(callee) && comes_back(callee);
  // std::shared_ptr<T>(weak)
  const bool is_from_weak =
      llvm::isa<clang::CXXConstructorDecl>(callee) && llvm::any_of(arguments, [](const auto* argument) {
        const clang::CXXRecordDecl* record =
            argument->IgnoreParenImpCasts()->getType().getNonReferenceType()->getAsCXXRecordDecl();
        return record && record->getIdentifier() && record->getName() == "weak_ptr";
      });
  return !is_from_weak && comes_back(callee);
}

}  // namespace

bool may_leave(const Unit& unit, const clang::Stmt* stmt) {
  if (llvm::isa<clang::CXXThrowExpr, clang::CoroutineSuspendExpr, clang::AsmStmt>(stmt)) return true;
  if (const auto* cast = llvm::dyn_cast<clang::CXXDynamicCastExpr>(stmt)) return cast->isGLValue();
  if (const auto* asked = llvm::dyn_cast<clang::CXXTypeidExpr>(stmt))
    return !asked->isTypeOperand() && asked->isPotentiallyEvaluated();
  const auto* made = llvm::dyn_cast<clang::CXXNewExpr>(stmt);
  if (!made || !made->isArray()) return false;
  const std::optional<const clang::Expr*> size = made->getArraySize();
  return size && *size && !is_bounded(unit, *size, made->getAllocatedType());
}

bool surely_returns(const Unit& unit, const clang::FunctionDecl* callee,
                    llvm::ArrayRef<const clang::Expr*> arguments) {
  if (callee->isNoReturn()) return false;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
  const bool is_of_message = method && message_of(method->getParent());
  if (is_noexcept(callee) || is_of_message || (method && method->isTrivial())) return true;
  if (callee->getBuiltinID() != 0 && callee->isExternC()) return comes_back(callee);
  return returns_by_arguments(unit, callee, arguments) && !brings_package(unit, callee, arguments);
}

}  // namespace tzc::rewriter
