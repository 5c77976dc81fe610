// One button per motion page.
import {el, setText} from './dom.js';

export class PageButtons {
  constructor(steering) {
    this.steering = steering;
    this.list = el('div', {className: 'page-buttons'});
    this.note = el('p', {className: 'note'}, 'A motion page moves the whole robot. It starts only when the robot stands still.');
    this.node = el('fieldset', {id: 'pages'}, el('legend', {}, 'Motion pages'), this.list, this.note);
    this.buttons = [];
    fetch('pages.json').then((answer) => answer.json()).then((pages) => this.begin(pages))
      .catch((error) => setText(this.note, `No motion pages: ${error.message}`));
    steering.addEventListener('change', () => this.update());
  }

  begin(pages) {
    this.buttons = pages.map(({number, name}) => {
      const button = el('button', {type: 'button', id: `page-${number}`, title: `Page ${number}`}, name || `Page ${number}`);
      button.addEventListener('click', () => this.steering.play(number));
      return {number, button};
    });
    this.list.replaceChildren(...this.buttons.map(({button}) => button));
    this.update();
  }

  update() {
    const {drives, doing} = this.steering;
    for (const {number, button} of this.buttons) {
      button.disabled = !drives || doing.walks || (doing.page !== 0 && doing.page !== number);
      button.setAttribute('aria-pressed', String(doing.page === number));
    }
  }
}
