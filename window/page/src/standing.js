// Estimates the trunk's position: it is not measured, so the lower foot is assumed not to move.
import {Quaternion, Vector3} from 'three';

const kUp = new Vector3(0, 0, 1);
const kOther = 0.004;   // m: hysteresis for a change of the standing foot
const kLying = 0.6;     // cosine of the lean beyond which no foot is assumed to stand

export class Standing {
  constructor(model) {
    this.model = model;
    this.feet = ['FootR', 'FootL'].map((name) => model.find(name)).filter(Boolean);
    this.reset();
  }

  reset() {
    this.stands = null;    // standing foot
    this.where = null;     // its position and heading
    this.heading = 0;
    this.place = new Vector3();
  }

  /// Places the trunk: `up` (in the trunk) points up, the standing foot stays, the lowest corner touches the floor.
  settle(up) {
    const trunk = this.model.trunk;
    const lean = new Quaternion().setFromUnitVectors(up.clone().applyQuaternion(this.model.upright), kUp);
    trunk.quaternion.setFromAxisAngle(kUp, this.heading).multiply(lean).multiply(this.model.upright);
    trunk.position.set(this.place.x, this.place.y, 0);
    trunk.updateMatrixWorld(true);
    const upright = new Vector3(0, 1, 0).applyQuaternion(this.model.upright).applyQuaternion(lean).z;
    if (upright > kLying && this.feet.length === 2) this.hold(lean);
    else this.stands = null;
    trunk.position.z -= lowest(this.model);
    trunk.updateMatrixWorld(true);
  }

  hold(lean) {
    const [low, high] = this.feet.map((foot) => ({foot, z: heightOf(foot)})).sort((a, b) => a.z - b.z);
    if (this.stands === null || (this.stands === high.foot && high.z - low.z > kOther)) {
      this.stands = low.foot;
      this.where = spotOf(this.stands);
      return;
    }
    const trunk = this.model.trunk;
    this.heading += shortest(this.where.heading - spotOf(this.stands).heading);
    trunk.quaternion.setFromAxisAngle(kUp, this.heading).multiply(lean).multiply(this.model.upright);
    trunk.updateMatrixWorld(true);
    const now = spotOf(this.stands);
    this.place.x += this.where.x - now.x;
    this.place.y += this.where.y - now.y;
    trunk.position.x = this.place.x;
    trunk.position.y = this.place.y;
    trunk.updateMatrixWorld(true);
  }
}

const shortest = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

// A foot's z axis points forward at zero, like the trunk's.
function spotOf(foot) {
  const e = foot.matrixWorld.elements;
  return {x: e[12], y: e[13], heading: Math.atan2(e[9], e[8])};
}

const corner = new Vector3();

function heightOf(link) {
  let least = Infinity;
  for (const mesh of link.children) {
    if (!mesh.isMesh) continue;
    const {min, max} = mesh.geometry.boundingBox;
    for (let i = 0; i < 8; ++i) {
      corner.set(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z).applyMatrix4(mesh.matrixWorld);
      least = Math.min(least, corner.z);
    }
  }
  return least;
}

function lowest(model) {
  return Math.min(...model.links.map(heightOf));
}
