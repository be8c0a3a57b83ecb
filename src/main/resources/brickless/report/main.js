// Puts the page together. A time behind the address (report.html#t=12.5) opens the run there.

function panel(id) {
  return document.getElementById(id);
}

/** Brick, behaviours and plots of one robot at a time, with a choice when there are several. */
function robotPanels(recording, player, group, robot) {
  const views = [];
  for (const id of ['brick', 'timeline', 'plots']) {
    panel(id).replaceChildren();
  }
  group.rows = [];
  if (recording.robots.length > 1) {
    const choice = html('select', {class: 'speed robot-choice', 'aria-label': 'Robot', on: {change: () => {
      player.views = player.views.filter((view) => !views.includes(view));
      robotPanels(recording, player, group, recording.robots[choice.selectedIndex]);
      player.show();
    }}}, ...recording.robots.map((one) => html('option', {selected: one === robot}, one.name)));
    panel('brick').append(choice);
  }
  views.push(new Brick(panel('brick'), recording, robot));
  const arbitrations = recording.arbitrations.filter((one) => one.robot === robot);
  panel('timeline').hidden = arbitrations.length === 0;
  if (arbitrations.length > 0) {
    views.push(new Timeline(panel('timeline'), arbitrations, group));
  }
  views.push(new Plots(panel('plots'), recording, robot, group));
  views.forEach((view) => player.add(view));
  group.redraw();
}

function timeInAddress() {
  const match = /\bt=([\d.]+)/.exec(location.hash);
  return match ? Number(match[1]) : 0;
}

async function open() {
  const source = panel('run');
  const recording = new Recording(await unpack(source.textContent));
  source.remove();
  document.body.dataset.state = 'ready';
  const player = new Player(recording.duration);
  const window = new TimeWindow(recording.duration);
  new Figures(panel('top'), recording);
  player.add(new Arena(panel('arena'), recording));
  const group = new TrackGroup(window, player);
  robotPanels(recording, player, group, recording.robots[0]);
  const lists = new Lists(panel('lists'), recording, player);
  player.add(lists);
  new Transport(panel('transport'), player, window, lists, lists.all);
  globalThis.addEventListener('hashchange', () => player.seek(timeInAddress()));
  player.seek(timeInAddress());
  panel('loading').remove();
}

open().catch((problem) => {
  document.body.dataset.state = 'failed';
  panel('loading').textContent = `This page cannot show the run: ${problem.message}`;
});
