#pragma once
#include <Eigen/Geometry>

namespace seiche {

/// How the tank stands and moves in the lab, as a rigid body. A point r of the tank is at
///   pivot + displacement + R (r - pivot),
/// R the rotation by `orientation`.
struct RigidState {
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();           ///< of the pivot, in the lab's axes [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< of the pivot, in the lab's axes [m/s]
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();           ///< of the pivot, in the lab's axes [m/s^2]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< from the tank's axes to the lab's
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();                  ///< angular velocity, in the tank's axes [rad/s]
  Eigen::Vector3d alpha = Eigen::Vector3d::Zero();  ///< its rate of change, in the tank's axes [rad/s^2]
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();  ///< in the tank's frame [m]

  /// Where the point r of the tank is in the lab [m].
  Eigen::Vector3d in_lab(const Eigen::Vector3d& r) const { return pivot + displacement + orientation * (r - pivot); }
};

}  // namespace seiche
