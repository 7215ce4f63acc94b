// SPDX-License-Identifier: BSD-3-Clause
// The little of Boost that the golden cases need: parsed in no time.
#pragma once
#include <functional>
#include <memory>
#include <utility>

namespace boost {
template <class T>
class shared_ptr {
 public:
  shared_ptr() = default;
  shared_ptr(decltype(nullptr)) {}
  template <class U>
  explicit shared_ptr(U* p) : p_(p) {}
  template <class U, class D>
  shared_ptr(U* p, D deleter) : p_(p, deleter) {}
  template <class U>  // with a second parameter, as boost has it
  shared_ptr(const shared_ptr<U>& other,
             typename std::enable_if<std::is_convertible<U*, T*>::value, int>::type = 0)
      : p_(other.p_) {}
  template <class U>
  shared_ptr(const shared_ptr<U>& owner, T* p) : p_(owner.p_, p) {}
  T* operator->() const { return p_.get(); }
  typename std::add_lvalue_reference<T>::type operator*() const { return *p_; }
  T* get() const { return p_.get(); }
  long use_count() const { return p_.use_count(); }
  bool unique() const { return p_.use_count() == 1; }
  void reset() { p_.reset(); }
  template <class U>
  void reset(U* p) {
    p_.reset(p);
  }
  explicit operator bool() const { return p_ != nullptr; }
  bool operator!() const { return !p_; }
  std::shared_ptr<T> p_;
};
template <class T, class... A>
shared_ptr<T> make_shared(A&&... a) {
  return shared_ptr<T>(new T(std::forward<A>(a)...));
}
template <class T, class U>
shared_ptr<T> const_pointer_cast(const shared_ptr<U>& p) {
  return shared_ptr<T>(const_cast<T*>(p.get()));
}
template <class F>
using function = std::function<F>;
template <class F, class... A>
auto bind(F&& f, A&&... a) {
  return std::bind(std::forward<F>(f), std::forward<A>(a)...);
}
namespace _bi {
template <class R, class F, class L>
struct bind_t {  // as boost has it: its type names the function's
  L list_;
  template <class... A>
  auto operator()(A&&... a) -> decltype(list_(std::forward<A>(a)...)) {
    return list_(std::forward<A>(a)...);
  }
};
}  // namespace _bi
template <class R, class... P, class... A>
auto bind(R (*f)(P...), A&&... a) {
  auto list = std::bind(f, std::forward<A>(a)...);
  return _bi::bind_t<R, R (*)(P...), decltype(list)>{list};
}
template <class T, unsigned long N>
struct array {
  T elems[N];
  T& operator[](unsigned long i) { return elems[i]; }
  const T& operator[](unsigned long i) const { return elems[i]; }
};
}  // namespace boost
using namespace std::placeholders;
