// Writes programs/three-camera.glb and .gltf by three.js r187, in a folder where it is installed; the tests do not run it.
import fs from "node:fs";
import * as THREE from "three";
import { GLTFExporter } from "three/examples/jsm/exporters/GLTFExporter.js";

globalThis.FileReader = class {
  async readAsArrayBuffer(blob) {
    this.result = await blob.arrayBuffer();
    this.onloadend();
  }
  async readAsDataURL(blob) {
    this.result = "data:application/octet-stream;base64," + Buffer.from(await blob.arrayBuffer()).toString("base64");
    this.onloadend();
  }
};
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera();
camera.name = "camera";
scene.add(camera);
const track = new THREE.VectorKeyframeTrack("camera.position", [0, 1, 2.5, 4], [0, 0, 0, 1, 2, 0, 3, 0, 1, 4, 1, 2]);
const animations = [new THREE.AnimationClip("fly", -1, [track])];
const exporter = new GLTFExporter();
fs.writeFileSync("programs/three-camera.glb", Buffer.from(await exporter.parseAsync(scene, { binary: true, animations })));
fs.writeFileSync("programs/three-camera.gltf", JSON.stringify(await exporter.parseAsync(scene, { animations })));
