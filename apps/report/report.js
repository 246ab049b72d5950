'use strict';
// One clock for the movie, the stills and the curves.
const main = document.querySelector('main');
const end = Number(main.dataset.end), interval = Number(main.dataset.interval);
const movie = document.querySelector('.movie'), video = document.querySelector('video');
const still = document.getElementById('still'), slider = document.getElementById('slider');
const play = document.getElementById('play'), clock = document.getElementById('clock');
const full = document.getElementById('full');
const strip = [...document.querySelectorAll('.strip button')];
const times = strip.map(button => Number(button.dataset.time));

function nearest(time) {
  let best = 0;
  times.forEach((t, i) => { if (Math.abs(t - time) < Math.abs(times[best] - time)) best = i; });
  return best;
}

function setClock(time) {
  const share = `${(100 * time / end).toFixed(3)}%`;
  for (const mark of document.querySelectorAll('.mark')) {
    mark.setAttribute('x1', share);
    mark.setAttribute('x2', share);
  }
  if (clock) clock.textContent = `t = ${time.toFixed(2)} s`;
  if (slider) {
    slider.value = nearest(time);
    slider.setAttribute('aria-valuetext', `t = ${times[nearest(time)].toFixed(2)} s`);
  }
  strip.forEach((button, i) => button.setAttribute('aria-current', i === nearest(time)));
}

function showMovie() {
  if (!movie) return;
  movie.hidden = false;
  if (still) still.hidden = true;
}

function showStill(index) {
  if (video) {
    video.pause();
    seek(times[index]);
  }
  const picture = strip[index].querySelector('img');
  still.src = picture.src;
  still.alt = picture.alt;
  still.hidden = false;
  if (movie) movie.hidden = true;
  setClock(times[index]);
}

// Into the middle of a frame: at its edge players differ.
function seek(time) {
  video.currentTime = Math.min(time + interval / 2, video.duration || 0);
}

// A frame shows its beginning.
function movieTime() {
  return Math.min(Math.floor(video.currentTime / interval + 1e-6) * interval, end);
}

function follow() {
  if (!movie.hidden) setClock(movieTime());
  if (!video.paused) requestAnimationFrame(follow);
}

function pointAt(time) {
  if (video) {
    showMovie();
    seek(time);
    setClock(time);
  } else if (strip.length > 0) {
    showStill(nearest(time));
  } else {
    setClock(time);
  }
}

function playOrPause() {
  if (video.paused) video.play().catch(() => {}); else video.pause();
}

if (video) {
  video.controls = false;
  video.tabIndex = 0;
  video.addEventListener('click', playOrPause);
  video.addEventListener('keydown', event => {
    if (event.key !== ' ' && event.key !== 'Enter') return;
    event.preventDefault();
    playOrPause();
  });
  video.addEventListener('play', () => { showMovie(); follow(); });
  for (const name of ['play', 'pause']) video.addEventListener(name, () => { play.textContent = video.paused ? 'Play' : 'Pause'; });
  video.addEventListener('seeked', follow);
  // A player may stop a frame later than it says.
  video.addEventListener('pause', () => seek(movieTime()));
  play.addEventListener('click', playOrPause);
} else if (play) {
  play.addEventListener('click', showMovie);
}
if (full && document.fullscreenEnabled) {
  const stage = document.querySelector('.stage');
  full.hidden = false;
  full.addEventListener('click', () => { if (document.fullscreenElement) document.exitFullscreen(); else stage.requestFullscreen(); });
}
if (slider) slider.addEventListener('input', () => showStill(Number(slider.value)));
strip.forEach((button, i) => button.addEventListener('click', () => showStill(i)));
for (const plot of document.querySelectorAll('.plot')) {
  const point = event => {
    const box = plot.querySelector('svg').getBoundingClientRect();
    pointAt(end * Math.min(1, Math.max(0, (event.clientX - box.left) / box.width)));
  };
  plot.addEventListener('pointerdown', point);
  plot.addEventListener('pointermove', event => { if (event.buttons === 1) point(event); });
}
for (const button of document.querySelectorAll('.key button')) {
  button.addEventListener('click', () => {
    const hide = button.getAttribute('aria-pressed') === 'true';
    button.setAttribute('aria-pressed', String(!hide));
    for (const line of document.querySelectorAll(`.plot .${button.dataset.run}`)) line.classList.toggle('off', hide);
  });
}
if (!movie && strip.length > 0) showStill(0); else setClock(0);
