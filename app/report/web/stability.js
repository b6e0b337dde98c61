// The table of `crest stability`, group by group.
{
  const stability = data;
  const finite = x => x === null ? 'not finite' : number(x);
  const failed = stability.rows.filter(row => row.verdict === 'FAIL').length;
  const limited = stability.rows.filter(row => row.verdict === 'limited').length;
  document.getElementById('subject').textContent = stability.renderer;
  document.getElementById('summary').textContent =
      `${stability.rows.length} cases: ${failed} do not keep their bound, ${limited} keep a measured limit of 32-bit float instead.`;
  const body = document.querySelector('#rows tbody');
  let group = '';
  for (const row of stability.rows) {
    if (row.group !== group) {
      group = row.group;
      const head = body.insertRow().insertCell();
      head.colSpan = 7;
      head.innerHTML = '<h3></h3>';
      head.firstChild.textContent = group;
    }
    const line = body.insertRow();
    const picture = line.insertCell();
    if (row.picture) {
      const image = document.createElement('img');
      image.src = row.picture;
      image.width = image.height = 48;
      image.alt = row.case;
      picture.append(image);
    }
    const limit = row.limit ? `${row.limit.why}: at most ${finite(row.limit.bound)}` : '';
    const texts = [row.case, row.quantity + (row.worst_at ? ` (worst at ${row.worst_at})` : ''), row.truth, finite(row.bound),
                   finite(row.measured), row.verdict === 'limited' ? `limited. ${limit}` : row.verdict];
    for (const text of texts) line.insertCell().textContent = text;
    if (row.verdict === 'FAIL') line.style.fontWeight = 'bold';
  }
}
