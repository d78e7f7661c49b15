// Jolt's bodies, joints and shapes [manual: jrouwe.github.io/JoltPhysics]. The vectors and settings that
// build a world are not destroyed, since the program ends soon.

import initJolt from 'jolt-physics';

import { beside, ground, isZero, minus } from './simulation.mjs';

export const Jolt = await initJolt();
const layer = 0;  // a single layer: all bodies touch each other

export const vector = ([x, y, z]) => new Jolt.Vec3(x, y, z);
export const place = ([x, y, z]) => new Jolt.RVec3(x, y, z);
const turn = ([w, x, y, z]) => new Jolt.Quat(x, y, z, w);

export class JoltWorld {
  constructor(world, defaults) {
    this.defaults = defaults;
    this.surface = { mFriction: world.friction, mRestitution: world.restitution };
    this.jolt = this.empty();
    this.system = this.jolt.GetPhysicsSystem();
    this.interface = this.system.GetBodyInterface();
    if (!defaults) {
      const settings = this.system.GetPhysicsSettings();
      Object.assign(settings,
        { mMinVelocityForRestitution: 0, mPenetrationSlop: 0, mSpeculativeContactDistance: 0 });
      this.system.SetPhysicsSettings(settings);
    }
    this.bodies = world.bodies.map((b) => this.body(b));
    for (const joint of world.joints) this.joint(joint);
    for (const spring of world.springs) this.spring(spring);
    if (!isZero(world.floor)) {
      const plane = new Jolt.PlaneShape(new Jolt.Plane(vector(world.floor), 0));
      this.add(new Jolt.BodyCreationSettings(plane, place([0, 0, 0]), turn([1, 0, 0, 0]),
        Jolt.EMotionType_Static, layer));
    }
  }

  of(body) { return body === ground ? this.jolt.sGetFixedToWorldBody() : this.bodies[body]; }

  empty() {
    const places = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
    const pairs = new Jolt.ObjectLayerPairFilterTable(1);
    places.MapObjectToBroadPhaseLayer(layer, new Jolt.BroadPhaseLayer(layer));
    pairs.EnableCollision(layer, layer);
    return new Jolt.JoltInterface(Object.assign(new Jolt.JoltSettings(), {
      mBroadPhaseLayerInterface: places,
      mObjectLayerPairFilter: pairs,
      mObjectVsBroadPhaseLayerFilter: new Jolt.ObjectVsBroadPhaseLayerFilterTable(places, 1, pairs, 1),
    }));
  }

  body({ mass, inertia, start: { position, orientation, velocity, spin }, shape: { kind, half } }) {
    const shape = kind === 'ball' ? new Jolt.SphereShape(half[0])
      : kind === 'box' ? new Jolt.BoxShape(vector(half)) : new Jolt.EmptyShapeSettings().Create().Get();
    const settings = new Jolt.BodyCreationSettings(shape, place(position), turn(orientation),
      Jolt.EMotionType_Dynamic, layer);
    settings.mLinearVelocity = vector(velocity);
    settings.mAngularVelocity = vector(spin);
    settings.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
    settings.mMassPropertiesOverride.mMass = mass;
    settings.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScaleVec3(vector(inertia));
    if (!this.defaults)
      Object.assign(settings, { mLinearDamping: 0, mAngularDamping: 0, mMaxAngularVelocity: 1e6,
        mApplyGyroscopicForce: true, mAllowSleeping: false });
    return this.add(settings);
  }
  add(settings) {
    const body = this.interface.CreateBody(Object.assign(settings, this.surface));
    this.interface.AddBody(body.GetID(), Jolt.EActivation_Activate);
    return body;
  }

  joint(joint) {
    const { kind, at, axis, end } = joint;
    const length = Math.hypot(...minus(end, at)), normal = beside(axis);
    if (kind === 'rod') {
      this.hold(new Jolt.DistanceConstraintSettings(), joint, { mPoint1: at, mPoint2: end }, {},
        { mMinDistance: length, mMaxDistance: length });
    } else if (kind === 'ball') {
      this.hold(new Jolt.PointConstraintSettings(), joint, { mPoint1: at, mPoint2: at });
    } else if (kind === 'hinge') {
      this.hold(new Jolt.HingeConstraintSettings(), joint, { mPoint1: at, mPoint2: at },
        { mHingeAxis1: axis, mHingeAxis2: axis, mNormalAxis1: normal, mNormalAxis2: normal });
    } else {
      const settings = new Jolt.SixDOFConstraintSettings();
      for (const fixed of ['TranslationY', 'TranslationZ', 'RotationY', 'RotationZ'])
        settings.MakeFixedAxis(Jolt[`SixDOFConstraintSettings_EAxis_${fixed}`]);
      this.hold(settings, joint, { mPosition1: at, mPosition2: at },
        { mAxisX1: axis, mAxisX2: axis, mAxisY1: normal, mAxisY2: normal });
    }
  }
  spring(ends) {
    const { at, end, stiffness, rest } = ends;
    const settings = new Jolt.DistanceConstraintSettings(), spring = settings.mLimitsSpringSettings;
    spring.mMode = Jolt.ESpringMode_StiffnessAndDamping;
    Object.assign(spring, { mStiffness: stiffness, mDamping: 0 });
    this.hold(settings, ends, { mPoint1: at, mPoint2: end }, {}, { mMinDistance: rest, mMaxDistance: rest });
  }
  hold(settings, { a, b }, places, directions = {}, numbers = {}) {
    for (const [name, at] of Object.entries(places)) settings[name] = place(at);
    for (const [name, along] of Object.entries(directions)) settings[name] = vector(along);
    this.system.AddConstraint(Object.assign(settings, numbers).Create(this.of(a), this.of(b)));
  }
}
