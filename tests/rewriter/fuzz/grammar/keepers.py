# SPDX-License-Identifier: BSD-3-Clause
"""What points into a message's array from inside code: closures, classes, functions, destructors and deleters."""
from .pointers import COUNT, Handle


def in_closure(program, element, source, array):
    return Handle([f"{element}* h0 = {source};", f"auto h = [h0](int i, {element} v) {{ h0[i] = v; }};"],
                  call="h({index}, {value});")


def in_function(program, element, source, array):
    return Handle([f"{element}* h0 = {source};",
                   f"boost::function<void(int, {element})> h = [h0](int i, {element} v) {{ h0[i] = v; }};"],
                  call="h({index}, {value});")


def closure_over_message(program, element, source, array):
    return Handle([f"auto h = [&](int i, {element} v) {{ {array}[i] = v; }};"], call="h({index}, {value});")


def in_class(program, element, source, array):
    kind = program.unique("Writer")
    program.prelude += [f"class {kind} {{", " public:", f"  explicit {kind}({element}* p) : p_(p) {{}}",
                        f"  void set(int i, {element} v) {{ p_[i] = v; }}", " private:", f"  {element}* p_;", "};"]
    return Handle([f"{kind} h({source});"], call="h.set({index}, {value});")


def smart_pointer(program, element, source, array):
    return Handle([f"boost::shared_ptr<{element}> h({source}, [](void*) {{}});"], "h.get()[{index}]")


def by_function(program, element, source, array):
    name = program.unique("write")
    program.prelude += [f"inline void {name}({element}* p, int i, {element} v) {{ p[i] = v; }}"]
    return Handle([f"{element}* h = {source};"], call=f"{name}(h, {{index}}, {{value}});")


def kept_by_algorithm(program, element, source, array):
    pair = f"std::pair<int, {element}>"
    return Handle([f"{element}* h0 = {source};", f"std::vector<{pair}> none;",
                   f"auto h = std::for_each(none.begin(), none.end(), [h0](const {pair}& p) {{ h0[p.first] = p.second; }});"],
                  call=f"h({pair}({{index}}, {{value}}));")


def in_standard_function(program, element, source, array):
    return Handle([f"{element}* h0 = {source};",
                   f"std::function<void(int, {element})> h = [h0](int i, {element} v) {{ h0[i] = v; }};"],
                  call="h({index}, {value});")


def in_function_member(program, element, source, array):
    kept = program.variable(f"std::function<void(int, {element})>", "writer")
    return Handle([f"{element}* h0 = {source};", f"{kept} = [h0](int i, {element} v) {{ h0[i] = v; }};"],
                  call=f"{kept}({{index}}, {{value}});")


def in_bound_call(program, element, source, array):
    name = program.unique("write")
    program.prelude += [f"inline void {name}({element}* p, int i, {element} v) {{ p[i] = v; }}"]
    return Handle([f"auto h = boost::bind(&{name}, {source}, boost::placeholders::_1, boost::placeholders::_2);"],
                  call=f"h({{index}}, static_cast<{element}>({{value}}));")


def in_initialized_capture(program, element, source, array):
    return Handle([f"auto h = [p = {source}](int i, {element} v) {{ p[i] = v; }};"], call="h({index}, {value});")


def in_generic_closure(program, element, source, array):
    return Handle([f"{element}* h0 = {source};", "auto h = [h0](auto i, auto v) { h0[i] = v; };"],
                  call="h({index}, {value});")


def in_template_class(program, element, source, array):
    kind = program.unique("View")
    program.prelude += ["template <class T>", f"struct {kind} {{", "  T* first;", "  int count;",
                        "  T& operator[](int i) const { return first[i]; }", "};"]
    return Handle([f"{kind}<{element}> h{{{source}, {COUNT}}};"], "h[{index}]")


def in_converting_class(program, element, source, array):
    kind = program.unique("Span")
    program.prelude += [f"struct {kind} {{", f"  {kind}({element}* p) : first(p) {{}}", f"  {element}* first;", "};"]
    return Handle([f"{kind} h = {source};"], "h.first[{index}]")


def kept_by_helper(program, element, source, array):
    kept = program.variable(f"{element}*", "place", " = nullptr")
    name = program.helper("void", "keep", f"{element}* p", [f"{kept} = p;"])
    return Handle([f"{name}({source});"], f"{kept}[{{index}}]")


def returned_by_helper(program, element, source, array):
    kept = program.variable(f"{element}*", "place", " = nullptr")
    name = program.helper(f"{element}*", "place", "", [f"return {kept};"])
    return Handle([f"{kept} = {source};"], f"{name}()[{{index}}]")


def kept_by_virtual_call(program, element, source, array):
    base, kind = program.unique("Keeper"), program.unique("RealKeeper")
    program.prelude += [f"struct {base} {{", f"  virtual ~{base}() {{}}", f"  virtual void take({element}* p) = 0;",
                        f"  virtual void set(int i, {element} v) = 0;", "};", f"struct {kind} : {base} {{",
                        f"  void take({element}* p) override {{ p_ = p; }}",
                        f"  void set(int i, {element} v) override {{ p_[i] = v; }}", f"  {element}* p_ = nullptr;", "};"]
    return Handle([f"{kind} real;", f"{base}& h = real;", f"h.take({source});"], call="h.set({index}, {value});")


def kept_by_template(program, element, source, array):
    name = program.unique("store")
    program.prelude += ["template <class T>", f"void {name}(T*& to, T* from) {{ to = from; }}"]
    return Handle([f"{element}* h = nullptr;", f"{name}(h, static_cast<{element}*>({source}));"], "h[{index}]")


def passed_through(program, element, source, array):
    name = program.unique("same")
    program.prelude += ["template <class T>", f"T {name}(T p) {{ return p; }}"]
    return Handle([f"auto h = {name}({source});"], "h[{index}]")


def late(program, element, end):
    """A class whose objects write to where they point each time that they are given another value, and when they end."""
    kind = program.unique("Late")
    program.prelude += [f"struct {kind} {{", f"  explicit {kind}({element}* p) : p_(p) {{}}", *end(kind),
                        f"  void set(int i, {element} v) {{ flush(); i_ = i; v_ = v; }}",
                        "  void flush() { p_[i_] = v_; }", f"  {element}* p_;", "  int i_ = 0;", f"  {element} v_ = 0;", "};"]
    return kind


def at_end(kind):
    return [f"  ~{kind}() {{ flush(); }}"]


def written_by_destructor(program, element, source, array):
    kind = late(program, element, at_end)
    return Handle([f"{kind} h({source});"], call="h.set({index}, {value});")


def written_by_element(program, element, source, array):
    """By the end of an object that a library's holds."""
    kind = late(program, element, at_end)
    held = program.rng.choice([[f"std::vector<{kind}> h;", "h.reserve(1);", f"h.emplace_back({source});"],
                               [f"std::array<{kind}, 1> h{{{{{kind}({source})}}}};"],
                               [f"std::deque<{kind}> h;", f"h.emplace_back({source});"]])
    return Handle(held, call="h[0].set({index}, {value});")


def written_by_cleanup(program, element, source, array):
    kind = late(program, element, lambda kind: [])
    close = program.unique("close")
    program.prelude += [f"inline void {close}({kind}* late) {{ late->flush(); }}"]
    return Handle([f"__attribute__((cleanup({close}))) {kind} h({source});"], call="h.set({index}, {value});")


def written_by_derived(program, element, source, array):
    """By the end of an object that a pointer to its base class ends."""
    base = program.unique("Base")
    program.prelude += [f"struct {base} {{", f"  virtual ~{base}() = default;",
                        f"  virtual void set(int i, {element} v) = 0;", "};"]
    kind = program.unique("Late")
    program.prelude += [f"struct {kind} : {base} {{", f"  explicit {kind}({element}* p) : p_(p) {{}}",
                        f"  ~{kind}() override {{ p_[2] = 9; }}",
                        f"  void set(int i, {element} v) override {{ p_[i] = v; }}",
                        f"  {element}* p_;", "};"]
    return Handle([f"std::unique_ptr<{base}> h(new {kind}({source}));"], call="h->set({index}, {value});")


def written_by_deleter(program, element, source, array):
    return Handle([f"boost::shared_ptr<{element}> h({source}, []({element}* p) {{ p[3] = 7; }});"],
                  call="{{ auto again = h; again.get()[{index}] = {value}; }}")


def written_by_thread(program, element, source, array):
    return Handle([f"{element}* h = {source};"], call="std::thread([&] {{ h[{index}] = {value}; }}).join();")


def by_context(program, element, source, array):
    """As C libraries call back: a function and an untyped pointer."""
    name = program.unique("call_back")
    program.prelude += [f"inline void {name}(void* context, int i, {element} v) {{",
                        f"  static_cast<{element}*>(context)[i] = v;", "}"]
    return Handle([f"void* context = {source};", f"void (*h)(void*, int, {element}) = &{name};"],
                  call="h(context, {index}, {value});")


def unique_pointer(program, element, source, array):
    kind = program.unique("Leave")
    program.prelude += [f"struct {kind} {{", "  template <class T>", "  void operator()(T*) const {}", "};"]
    return Handle([f"std::unique_ptr<{element}, {kind}> h({source});"], "h.get()[{index}]")


def pointer_to_member(program, element, source, array):
    kind = program.unique("Field")
    program.prelude += [f"struct {kind} {{", f"  {element}* p;", "};"]
    return Handle([f"{element}* {kind}::*h = &{kind}::p;", f"{kind} holder{{{source}}};"], "(holder.*h)[{index}]")


def second_closure(program, element, source, array):
    return Handle([f"{element}* h0 = {source};", f"auto inner = [&h0](int i, {element} v) {{ h0[i] = v; }};",
                   f"auto h = [&inner](int i, {element} v) {{ inner(i, v); }};"], call="h({index}, {value});")


# Code that takes anything, and that a library gives the message to
# ----------------------------------------------------------------------------------------------------------------------


def message_and_field(array):
    message, arrow, field = array.rpartition("->" if "->" in array else ".")
    return (f"(*{message})" if arrow == "->" else message), field


def generic_algorithm(program, element, source, array):
    message, field = message_and_field(array)
    return Handle([f"{element}* h = nullptr;",
                   f"std::find_if(&{message}, &{message} + 1, [&](auto& one) {{ return !(h = one.{field}.data()); }});"],
                  "h[{index}]")


def generic_call(program, element, source, array):
    message, field = message_and_field(array)
    closure = f"[&](auto& one) -> auto& {{ return h = one.{field}.data(), one; }}"
    call = program.rng.choice([f"std::invoke({closure}, {message});", f"std::apply({closure}, std::tie({message}));"])
    return Handle([f"{element}* h = nullptr;", call], "h[{index}]")


def generic_object(program, element, source, array):
    message, field = message_and_field(array)
    kind = program.unique("Keeper")
    program.prelude += [f"struct {kind} {{", "  template <class Message>",
                        f"  explicit {kind}(Message& message) : p(message.{field}.data()) {{}}", f"  {element}* p;", "};"]
    return Handle([f"const auto h = std::make_shared<{kind}>({message});"], "h->p[{index}]")


STORES = [in_closure, in_function, closure_over_message, in_class, smart_pointer, by_function, kept_by_algorithm,
          in_standard_function, in_function_member, in_bound_call, in_initialized_capture, in_generic_closure,
          in_template_class, in_converting_class, kept_by_helper, returned_by_helper, kept_by_virtual_call,
          kept_by_template, passed_through, written_by_destructor, written_by_element, written_by_cleanup, written_by_derived,
          written_by_deleter, written_by_thread, by_context, unique_pointer, pointer_to_member, second_closure,
          generic_algorithm, generic_call, generic_object]

# They write when they end, which is after what took the elements over ended.
WRITE_AT_END = [written_by_destructor, written_by_element, written_by_cleanup, written_by_derived, written_by_deleter]
