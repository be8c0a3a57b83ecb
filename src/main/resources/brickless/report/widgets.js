// Buttons, tabs and the list of keys.

const PLAY_ICON = 'M5 3.2v13.6a.6.6 0 0 0 .9.5l11-6.8a.6.6 0 0 0 0-1L5.9 2.7a.6.6 0 0 0-.9.5z';
const PAUSE_ICON = 'M5 3h3.4v14H5zM11.6 3H15v14h-3.4z';

/** A round button with an icon and a name. */
function iconButton(name, content, action, className) {
  return html('button', {type: 'button', class: `icon-button ${className}`, 'aria-label': name, title: name, on: {click: action}}, content);
}

/** A dialog that lists keys and what they do. */
function helpDialog(keys) {
  const dialog = html('dialog', {class: 'help', 'aria-label': 'Keys', on: {click: (event) => event.target === dialog && dialog.close()}},
    html('h2', {}, 'Keys'), html('dl', {}, ...keys.flatMap(([names, what]) => [html('dt', {}, ...names.split(' ').map((name) => html('kbd', {}, name))), html('dd', {}, what)])),
    html('form', {method: 'dialog'}, html('button', {class: 'chip'}, 'Close')));
  return dialog;
}

/** Tabs from [title, body, count]; gives the elements that show the counts. */
function tabs(host, pages) {
  const list = html('div', {class: 'tabs', role: 'tablist'});
  const select = (chosen) => pages.forEach(([, body], i) => {
    body.hidden = i !== chosen;
    list.children[i].setAttribute('aria-selected', String(i === chosen));
    list.children[i].tabIndex = i === chosen ? 0 : -1;
  });
  const counts = pages.map(([title, body, count], i) => {
    body.id = `tab-${title.toLowerCase()}`;
    body.setAttribute('role', 'tabpanel');
    const shown = html('span', {class: 'count'}, String(count));
    list.append(html('button', {type: 'button', role: 'tab', 'aria-controls': body.id, on: {click: () => select(i), keydown: (event) => {
      if (event.key === 'ArrowLeft' || event.key === 'ArrowRight') {
        event.stopPropagation();
        select(1 - i);
        list.children[1 - i].focus();
      }
    }}}, title, shown));
    return shown;
  });
  host.append(list, ...pages.map(([, body]) => body));
  select(0);
  return counts;
}
