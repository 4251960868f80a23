// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/animate/animation.hpp"

namespace magicmass::command {

const char* const animation_player = R"js('use strict';
(() => {
  const element = (id) => document.getElementById(id);
  const motion = JSON.parse(element('motion').textContent);
  const bodies = motion.names.length;
  const contacts = motion.contacts; // [time, position, gap, v_left, v_right]
  const span = motion.end - motion.begin;
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const shapes = motion.names.map((_, body) => element('body-' + body));
  const rows = motion.names.map((_, body) => element('row-' + body));

  // Straight lines of each body: [contacts of all bodies so far, time, position, velocity]
  const pieces = motion.x.map((x, body) => [[0, 0, x, motion.v[body]]]);
  contacts.forEach(([time, x, gap, left, right], i) => {
    if (gap > 0) pieces[gap - 1].push([i + 1, time, x, left]);
    if (gap < bodies) pieces[gap].push([i + 1, time, x, right]);
  });

  let time = motion.begin;
  let done = 0; // contacts that have happened
  let playing = false;
  let before = 0; // when the last picture was drawn

  // How many of the sorted items come before the first that fails the test
  const count = (items, test) => {
    let low = 0, high = items.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (test(items[middle])) low = middle + 1;
      else high = middle;
    }
    return low;
  };
  const pieceOf = (body) => pieces[body][count(pieces[body], (piece) => piece[0] <= done) - 1];
  const short = (value) => String(Number(value.toPrecision(5)));
  // Doubles leave some rounding where the exact velocity is 0
  const fastest = Math.max(...motion.v.map(Math.abs));
  const shortVelocity = (v) => v !== 0 && Math.abs(v) < 1e-12 * fastest ? '≈ 0' : short(v);
  const nameOf = (body) => body < 0 || body >= bodies ? 'the wall' : motion.labels[body];

  const words = () => {
    const all = contacts.length + (motion.cut ? ' shown' : '');
    if (done === 0) return 'Time ' + short(time) + ', before the first collision (of ' + all + ')';
    const gap = contacts[done - 1][2];
    return 'Time ' + short(time) + ', after collision ' + done + ' of ' + all + ': ' +
      nameOf(gap - 1) + ' and ' + nameOf(gap);
  };

  const show = () => {
    const now = motion.names.map((_, body) => {
      const [, since, from, velocity] = pieceOf(body);
      return [from + velocity * (time - since), velocity];
    });
    // Room at first for the beginning, then for all bodies, wherever they are
    const left = Math.min(motion.left, now[0][0]);
    const scale = motion.room / (Math.max(motion.right, now[bodies - 1][0]) - left);
    now.forEach(([x, velocity], body) => {
      const at = motion.offsets[body] + scale * (x - left);
      shapes[body].setAttribute('transform', 'translate(' + at.toFixed(3) + ' 0)');
      rows[body].cells[2].textContent = short(x);
      rows[body].cells[3].textContent = shortVelocity(velocity);
    });
    element('time').value = (time - motion.begin) / span;
    element('time').setAttribute('aria-valuetext', short(time));
    element('now').textContent = words();
    element('play').textContent = playing ? 'Pause' : 'Play';
    document.documentElement.dataset.done = done;
    document.documentElement.dataset.time = time;
  };
  // Screen readers hear of steps and pauses, not of every picture
  const say = () => { element('said').textContent = words(); };

  const goTo = (moment, after) => {
    time = moment;
    done = after;
    show();
  };
  const forward = () => {
    if (done < contacts.length) goTo(contacts[done][0], done + 1);
    else goTo(motion.end, done);
  };
  const back = () => {
    if (done > 0 && time > contacts[done - 1][0]) goTo(contacts[done - 1][0], done);
    else if (done > 1) goTo(contacts[done - 2][0], done - 1);
    else goTo(motion.begin, 0);
  };
  const atTime = (moment) => goTo(moment, count(contacts, (contact) => contact[0] <= moment));

  const frame = (now) => {
    if (!playing) return;
    const speed = Number(element('speed').value);
    if (calm.matches) {
      if ((now - before) * speed >= 1000) { forward(); before = now; }
    } else {
      const seconds = Math.min(0.1, (now - before) / 1000);
      before = now;
      atTime(Math.min(motion.end, time + seconds * speed * motion.pace));
    }
    if (time >= motion.end) pause();
    else requestAnimationFrame(frame);
  };
  const play = () => {
    if (time >= motion.end) atTime(motion.begin);
    playing = true;
    before = performance.now();
    show();
    requestAnimationFrame(frame);
  };
  const pause = () => { playing = false; show(); say(); };

  const actions = {
    first: () => { pause(); atTime(motion.begin); say(); },
    back: () => { pause(); back(); say(); },
    play: () => { if (playing) pause(); else play(); },
    forward: () => { pause(); forward(); say(); },
    last: () => { pause(); goTo(motion.end, contacts.length); say(); },
  };
  for (const [name, action] of Object.entries(actions)) element(name).addEventListener('click', action);
  const keys = { ' ': 'play', ArrowLeft: 'back', ArrowRight: 'forward', Home: 'first', End: 'last' };
  document.addEventListener('keydown', (event) => {
    const name = keys[event.key];
    if (!name || event.ctrlKey || event.altKey || event.metaKey) return;
    const at = event.target.tagName;
    // What has the focus keeps the keys that it knows itself
    if (at === 'SELECT' || at === 'INPUT' || ((at === 'BUTTON' || at === 'SUMMARY') && event.key === ' ')) return;
    event.preventDefault();
    if (name !== 'play' || !event.repeat) actions[name]();
  });
  element('time').addEventListener('input', (event) => {
    pause();
    atTime(motion.begin + span * Number(event.target.value));
  });
  const tell = () => { element('calm').hidden = !calm.matches; };
  calm.addEventListener('change', tell);
  tell();
  show();
})();
)js";

}  // namespace magicmass::command
