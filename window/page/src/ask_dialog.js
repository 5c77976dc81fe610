// Confirmation dialog; Escape cancels.
import {el} from './dom.js';

let asked = 0;

/// Resolves to true or false. `paragraphs`: strings or elements.
export function ask(title, paragraphs, yes, no = 'Cancel') {
  const id = `ask-${++asked}`;
  const accept = el('button', {type: 'button', className: 'danger'}, yes), refuse = el('button', {type: 'button'}, no);
  const node = el('dialog', {'aria-labelledby': id}, el('h2', {id}, title), ...paragraphs.map((text) => el('p', {}, text)),
    el('div', {className: 'choices'}, refuse, accept));
  document.body.append(node);
  return new Promise((done) => {
    accept.addEventListener('click', () => node.close('yes'));
    refuse.addEventListener('click', () => node.close());
    node.addEventListener('close', () => { node.remove(); done(node.returnValue === 'yes'); });
    node.showModal();
    refuse.focus();
  });
}
