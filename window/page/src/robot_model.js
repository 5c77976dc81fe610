// 3D model of the robot from the shapes of the twin's body file.
import {
  BoxGeometry, BufferAttribute, CapsuleGeometry, Color, CylinderGeometry, Group, Matrix4, Mesh, MeshLambertMaterial,
  Quaternion, SphereGeometry, SRGBColorSpace, Vector3,
} from 'three';
import {mergeGeometries} from 'three/addons/utils/BufferGeometryUtils.js';
import {kGraphicsCard} from './graphics.js';

const quaternion = ([w, x, y, z]) => new Quaternion(x, y, z, w);
const kLieAlongZ = Math.PI / 2;  // three.js cylinders are along y, MuJoCo's along z

// Segments of round shapes; software rendering time grows with triangles.
const kRound = kGraphicsCard ? 20 : 10, kUpDown = kRound / 2 + 1, kCap = kRound / 5 + 1;

function geometryOf({type, size}) {
  switch (type) {
    case 'box': return new BoxGeometry(2 * size[0], 2 * size[1], 2 * size[2]);
    case 'sphere': return new SphereGeometry(size[0], kRound, kUpDown);
    case 'ellipsoid': return new SphereGeometry(1, kRound, kUpDown).scale(...size);
    case 'capsule': return new CapsuleGeometry(size[0], 2 * size[1], kCap, kRound).rotateX(kLieAlongZ);
    case 'cylinder': return new CylinderGeometry(size[0], size[0], 2 * size[1], kRound).rotateX(kLieAlongZ);
    default: throw new Error(`unsupported shape: ${type}`);
  }
}

// Merges all shapes of a link with their colours: one draw call per link.
function pieceOf(shapes) {
  const parts = shapes.map((shape) => {
    const part = geometryOf(shape);
    part.applyMatrix4(new Matrix4().compose(new Vector3(...shape.pos), quaternion(shape.quat), new Vector3(1, 1, 1)));
    const {r, g, b} = new Color().setRGB(...shape.colour, SRGBColorSpace);
    const colours = new Float32Array(3 * part.attributes.position.count);
    for (let i = 0; i < colours.length; i += 3) colours.set([r, g, b], i);
    part.setAttribute('color', new BufferAttribute(colours, 3));
    part.deleteAttribute('uv');
    return part;
  });
  return mergeGeometries(parts);
}

export class RobotModel {
  /// `body`: body.json. `material`: null: the shapes' own colours.
  constructor(body, material = null) {
    this.joints = new Map();  // name: {link, axis, zero}
    this.links = body.links.map((link) => {
      const group = new Group();
      group.name = link.name;
      group.position.set(...link.pos);
      group.quaternion.copy(quaternion(link.quat));
      if (link.shapes.length > 0) {
        const mesh = new Mesh(pieceOf(link.shapes), material ?? new MeshLambertMaterial({vertexColors: true}));
        mesh.geometry.computeBoundingBox();
        group.add(mesh);
      }
      if (link.joint)
        this.joints.set(link.joint.name, {
          link: group, axis: new Vector3(...link.joint.axis).normalize(), zero: group.quaternion.clone(),
          home: group.position.clone(), pivot: new Vector3(...link.joint.pos)});
      return group;
    });
    body.links.forEach((link, i) => link.parent >= 0 && this.links[link.parent].add(this.links[i]));
    this.parents = body.links.map((link) => link.parent);
    this.joint_of = body.links.map((link) => link.joint?.name ?? null);
    [this.trunk] = this.links;
    this.upright = this.trunk.quaternion.clone();
    this.turn = new Quaternion();
  }

  find(name) { return this.links.find((link) => link.name === name); }

  /// Colours the links that these joints move, by name; null: their own colours.
  tint(colours) {
    this.links.forEach((link, i) => {
      const colour = colours?.get(this.joint_of[i]) ?? 0x000000;  // light of its own, added to that of the lamps
      for (const child of link.children) if (child.isMesh) child.material.emissive.set(colour);
    });
  }

  /// Name of the joint that moves a link, or null.
  jointOf(link) { return this.joint_of[this.links.indexOf(link)] ?? null; }

  /// Sets a joint, rad; an unknown angle changes nothing.
  setJoint(name, angle) {
    const joint = this.joints.get(name);
    if (!joint || typeof angle !== 'number') return;
    joint.link.quaternion.copy(joint.zero).multiply(this.turn.setFromAxisAngle(joint.axis, angle));
    // rotate about the pivot, which may differ from the link's origin
    if (joint.pivot.lengthSq() === 0) return;
    joint.link.position.copy(joint.pivot).applyQuaternion(joint.zero).add(joint.home)
      .sub(joint.pivot.clone().applyQuaternion(joint.link.quaternion));
  }

  /// Shows only links moved by a joint of `apart` (names). True if any.
  showOnly(apart) {
    const shown = [];
    this.links.forEach((link, i) => {
      shown[i] = apart.has(this.joint_of[i]) || (this.parents[i] >= 0 && shown[this.parents[i]]);
      for (const child of link.children) if (child.isMesh) child.visible = shown[i];
    });
    return shown.includes(true);
  }
}
