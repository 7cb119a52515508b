// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shows the scenes of each figure side by side, with one camera for all. Browsers allow few WebGL contexts a page, so one
// renderer draws them all, and each picture is copied into a canvas of its own.

"use strict";

const PICTURE_SIZE = 340;          // pixels
const BACKGROUND = 0xffffff;
const UNKNOWN_NORMAL = 150;        // gray
const FIELD_OF_VIEW = 30;          // degrees
const SIZE_OF_POINTS = 1.4;        // spacings, so that little is seen through what lies in front

const renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
renderer.setSize(PICTURE_SIZE, PICTURE_SIZE, false);
renderer.setClearColor(BACKGROUND);

async function unpack(text) {
  const bytes = Uint8Array.from(atob(text), character => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

function attribute(array, size, normalized) {
  return new THREE.BufferAttribute(array, size, normalized);
}

// As in the paper: the direction of the normal is the color.
function colorsOfNormals(normals, count) {
  const colors = new Uint8Array(3 * count).fill(UNKNOWN_NORMAL);
  if (normals)
    normals.forEach((value, i) => { colors[i] = 128 + value; });
  return colors;
}

// Blue where there is none, over green and yellow to red.
function colorsOfErrors(errors) {
  const colors = new Uint8Array(3 * errors.length);
  const color = new THREE.Color();
  errors.forEach((error, i) => {
    color.setHSL((1 - error / 255) * 2 / 3, 0.85, 0.5);
    colors.set([255 * color.r, 255 * color.g, 255 * color.b], 3 * i);
  });
  return colors;
}

async function pointsOf(scene) {
  const {count, has_normals, data} = scene.points;
  const buffer = await unpack(data);
  const normals = has_normals ? new Int8Array(buffer, 6 * count, 3 * count) : null;
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", attribute(new Int16Array(buffer, 0, 3 * count), 3, true));
  geometry.setAttribute("color", attribute(colorsOfNormals(normals, count), 3, true));
  // three.js sizes points as if the field of view were 90 degrees.
  const size = SIZE_OF_POINTS * scene.spacing / Math.tan(FIELD_OF_VIEW / 2 * Math.PI / 180);
  const material = new THREE.PointsMaterial({size, vertexColors: THREE.VertexColors});
  return new THREE.Points(geometry, material);
}

async function meshesOf(scene) {
  const {vertices, triangles, data, has_errors} = scene.mesh;
  const buffer = await unpack(data);
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(attribute(new Uint32Array(buffer, 0, 3 * triangles), 1, false));
  geometry.setAttribute("position", attribute(new Int16Array(buffer, 12 * triangles, 3 * vertices), 3, true));
  const errors = new Uint8Array(buffer, 12 * triangles + 6 * vertices, vertices);
  geometry.setAttribute("color", attribute(colorsOfErrors(errors), 3, true));
  const look = {side: THREE.DoubleSide, flatShading: true, shininess: 0};   // flat, so that edges and noise show
  const meshes = {mesh: new THREE.Mesh(geometry, new THREE.MeshPhongMaterial({...look, color: 0xc0c0c0}))};
  if (has_errors)
    meshes.error = new THREE.Mesh(geometry, new THREE.MeshPhongMaterial({...look, vertexColors: THREE.VertexColors}));
  return meshes;
}

function newCamera(figure) {
  const camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.05, 50);
  camera.position.set(...figure.eye);
  camera.up.set(...figure.up);
  // A light that goes with the eye
  const light = new THREE.DirectionalLight(0xffffff, 0.85);
  light.position.set(-0.4, 0.6, 1);
  camera.add(light, light.target);
  return camera;
}

class Picture {
  constructor(scene, camera, requestDrawing) {
    this.root = new THREE.Scene();
    this.root.add(camera.clone(), new THREE.AmbientLight(0xffffff, 0.35));
    this.camera = camera;
    this.element = document.createElement("figure");
    this.canvas = this.element.appendChild(document.createElement("canvas"));
    this.canvas.width = this.canvas.height = PICTURE_SIZE;
    this.element.appendChild(document.createElement("figcaption")).textContent =
      scene.title + (scene.remark ? ` (${scene.remark})` : "");
    const controls = new THREE.OrbitControls(camera, this.canvas);
    controls.enablePan = false;    // the center is common to all pictures of a figure
    controls.addEventListener("change", requestDrawing);
  }

  async load(scene) {
    this.objects = {points: await pointsOf(scene), ...(scene.mesh ? await meshesOf(scene) : {})};
  }

  draw(view) {
    const object = this.objects[view] || this.objects.points;   // the input has no mesh
    const context = this.canvas.getContext("2d");
    context.clearRect(0, 0, PICTURE_SIZE, PICTURE_SIZE);
    this.root.children[0].position.copy(this.camera.position);
    this.root.children[0].quaternion.copy(this.camera.quaternion);
    this.root.add(object);
    renderer.render(this.root, this.camera);
    this.root.remove(object);
    context.drawImage(renderer.domElement, 0, 0);
  }
}

// Loads a figure once it is seen, and draws it whenever its camera or what it shows changes.
async function showFigure(element) {
  const figure = JSON.parse(document.getElementById(element.dataset.figure).textContent);
  const camera = newCamera(figure);
  let view = "points", isRequested = false;
  const pictures = [];
  const draw = () => { isRequested = false; pictures.forEach(picture => picture.draw(view)); };
  const requestDrawing = () => {
    if (!isRequested)
      requestAnimationFrame(draw);
    isRequested = true;
  };

  const views = {points: "points", mesh: "Poisson mesh", error: `error, red from ${figure.largest_error} %`};
  const bar = element.appendChild(document.createElement("div"));
  const row = element.appendChild(document.createElement("div"));
  row.className = "pictures";
  for (const scene of figure.scenes) {
    const picture = new Picture(scene, camera, requestDrawing);
    await picture.load(scene);
    row.appendChild(picture.element);
    pictures.push(picture);
  }
  for (const [name, label] of Object.entries(views)) {
    if (!pictures.some(picture => picture.objects[name]))
      continue;
    const button = bar.appendChild(document.createElement("button"));
    button.textContent = label;
    button.dataset.view = name;
    button.addEventListener("click", () => { view = name; requestDrawing(); });
  }
  draw();
  element.dataset.state = "shown";
}

const observer = new IntersectionObserver(entries => {
  for (const entry of entries)
    if (entry.isIntersecting) {
      observer.unobserve(entry.target);
      showFigure(entry.target);
    }
}, {rootMargin: "300px"});
document.querySelectorAll(".scenes").forEach(element => observer.observe(element));
