// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc::rewriter {

/// Hidden until the script shows them: without scripts every site is listed.
constexpr const char* html_filters = R"html(<form class="filters" id="filters" hidden>
<label>show sites with <input type="search" name="text" placeholder="file, topic, message, code"></label>
<label>kind <select name="kind"><option value="">all</option><option>advertise</option><option>publish</option><option>subscribe</option></select></label>
<label>level <select name="level"><option value="">all</option><option>zero_copy</option><option>one_copy</option><option>shared</option><option>copied</option><option>plain</option><option>not_needed</option></select></label>
<output name="count"></output>
</form>
)html";

/// A site's row and the row of its remark go together.
constexpr const char* html_script = R"js(
const form = document.getElementById('filters');
const sites = [...document.querySelectorAll('tr.site')].map(row => {
  const why = row.classList.contains('has-why') ? row.nextElementSibling : null;
  return {rows: why ? [row, why] : [row], kind: row.dataset.kind, level: row.dataset.level,
          text: (row.textContent + ' ' + (why ? why.textContent : '')).toLowerCase()};
});
function filter() {
  const text = form.elements.text.value.trim().toLowerCase();
  const kind = form.elements.kind.value, level = form.elements.level.value;
  let shown = 0;
  for (const site of sites) {
    const fits = site.text.includes(text) && (!kind || site.kind === kind) && (!level || site.level === level);
    for (const row of site.rows) row.hidden = !fits;
    shown += fits;
  }
  form.elements.count.textContent = shown + ' of ' + sites.length + ' sites';
}
form.addEventListener('input', filter);
form.addEventListener('submit', event => event.preventDefault());
form.hidden = sites.length < 2;
filter();
)js";

}  // namespace tzc::rewriter
