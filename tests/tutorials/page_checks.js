// SPDX-License-Identifier: GPL-2.0-or-later
// What a reader needs of a page, as far as a browser can tell: run inside the page, complaints go to the parent.
"use strict";

const complaints = [];
const complain = (what, element) =>
  complaints.push(what + (element ? ": " + (element.textContent || element.outerHTML).trim().slice(0, 40) : ""));

function channels(colour) {
  const parts = colour.match(/[\d.]+/g).map(Number);
  return parts.length < 4 ? [...parts, 1] : parts;
}
function luminance([r, g, b]) {
  const [x, y, z] = [r, g, b].map((c) => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  return 0.2126 * x + 0.7152 * y + 0.0722 * z;
}
function background(element) {
  for (let e = element; e; e = e.parentElement) {
    const colour = channels(getComputedStyle(e).backgroundColor);
    if (colour[3] > 0) return colour;
  }
  return [255, 255, 255, 1];
}

function checkContrast() { // WCAG: 4.5, for large letters 3
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const element = node.parentElement;
    if (!node.data.trim() || element.closest("script")) continue;
    const style = getComputedStyle(element);
    const [x, y] = [luminance(channels(style.color)), luminance(background(element))];
    const ratio = (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
    if (ratio < (parseFloat(style.fontSize) >= 24 ? 3 : 4.5)) complain("contrast " + ratio.toFixed(2), element);
  }
}

function checkKeyboard() {
  const reachable = [...document.querySelectorAll("a[href], [tabindex]")].filter((e) => e.tabIndex >= 0);
  if (!reachable.length || reachable[0].className !== "skip") complain("the first stop is no link to the text");
  for (const element of reachable) {
    if (element.tabIndex > 0) complain("out of order", element);
    element.focus();
    if (document.activeElement !== element) complain("cannot be reached", element);
    if (getComputedStyle(element).outlineStyle === "none") complain("does not show that it is reached", element);
    if (element.hash && element.pathname === location.pathname && !document.getElementById(element.hash.slice(1)))
      complain("leads nowhere", element);
  }
  for (const element of document.querySelectorAll("main *")) {
    const scrolls = /auto|scroll/.test(getComputedStyle(element).overflowX);
    if (scrolls && element.scrollWidth > element.clientWidth + 2 && element.tabIndex < 0)
      complain("scrolls, but not with the keyboard", element);
  }
}

function checkStructure() {
  if (!document.documentElement.lang || !document.title) complain("no language or title");
  let level = 0;
  for (const heading of document.querySelectorAll("h1, h2, h3, h4")) {
    const next = Number(heading.tagName[1]);
    if (next > level + 1) complain("a heading skips a level", heading);
    level = next;
  }
  if (document.querySelectorAll("h1").length !== 1) complain("not one h1");
  for (const image of document.images) {
    if (image.alt.length < 20) complain("a picture without description", image);
    if (!image.naturalWidth) complain("a picture that does not load", image);
  }
  const width = document.documentElement.scrollWidth;
  if (width > innerWidth) complain("wider than the window of " + innerWidth + ": " + width);
}

addEventListener("load", () => {
  checkStructure();
  checkContrast();
  checkKeyboard();
  parent.postMessage(document.title + " at " + innerWidth + ": " + (complaints.join("; ") || "good"), "*");
});
