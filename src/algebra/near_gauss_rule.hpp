#pragma once
#include <array>

namespace phrame::inline v0 {

/// A point x > 0 of Gauss's rule of 64 points on [−1, 1], which −x is, too, and its weight, as
/// pairs of doubles next to them: by Newton's iteration with 260 bits, in mpmath. To find them by
/// balls, as a test does, takes as long as a hundred integrals.
struct NearGaussPoint {
  double high;
  double low;
  double weight_high;
  double weight_low;
};

inline constexpr std::array<NearGaussPoint, 32> near_gauss_rule{{
    {0x1.8ef487a8cbc33p-6, -0x1.c7ef5f73772e4p-67, 0x1.8ee0567ee2e50p-5, -0x1.e7abbc78cc18ap-59},
    {0x1.2afad5ee95ad0p-4, -0x1.ae618d60679c4p-59, 0x1.8dee238192cd0p-5, -0x1.78f6b6798e3ddp-60},
    {0x1.f182ff48e8a27p-4, -0x1.18dbc83a52ce4p-58, 0x1.8c0a5097676bap-5, 0x1.a54e265a4e50ap-59},
    {0x1.5b6e88ad5c00fp-3, -0x1.e06fd0c9a3b70p-57, 0x1.89360387fe3a9p-5, -0x1.7b0816965c157p-59},
    {0x1.bd489b79ec83bp-3, 0x1.249b2376365a3p-60, 0x1.8572f41fbb52dp-5, 0x1.7b2c53b0cde02p-62},
    {0x1.0f0a26c56e49cp-2, -0x1.0b6071cbf19b3p-57, 0x1.80c36b24bdd19p-5, -0x1.c480fe299fc9fp-59},
    {0x1.3ecb6c46c76cbp-2, -0x1.f7206c100fd77p-57, 0x1.7b2a40f3ccddap-5, 0x1.2039a9059375cp-60},
    {0x1.6dcb1f0620fffp-2, -0x1.61aaeb74f9768p-57, 0x1.74aadbc614fb3p-5, 0x1.67e1c76316d95p-59},
    {0x1.9becb55272c9dp-2, -0x1.987390845bfa8p-56, 0x1.6d492da0c2510p-5, -0x1.d2d14083c0fc4p-59},
    {0x1.c9142c5898fc5p-2, 0x1.49fd6534bb4c5p-60, 0x1.6509b1efb8deep-5, 0x1.b3998aa521badp-59},
    {0x1.f52619257c3a1p-2, 0x1.149bbf9d0b421p-59, 0x1.5bf16accdf42ep-5, -0x1.f949ae23f6607p-60},
    {0x1.1003dca600f34p-1, -0x1.658e1956383b5p-56, 0x1.5205ddf5a36dbp-5, 0x1.3c9f239fae144p-60},
    {0x1.24cf81925487fp-1, 0x1.386e29cd44512p-55, 0x1.474d117092813p-5, -0x1.692bc143a0ae8p-60},
    {0x1.38e95ace7b3c3p-1, -0x1.f7db6d88796fbp-56, 0x1.3bcd87e50de1cp-5, 0x1.d3b7e37a7c821p-59},
    {0x1.4c4533c68b412p-1, 0x1.084313fba4fdap-55, 0x1.2f8e3ca7574ddp-5, -0x1.cbd64ea9d8e50p-61},
    {0x1.5ed74b4532f83p-1, -0x1.ffe95e4d9546ap-56, 0x1.22969f7b5c8c9p-5, -0x1.2df092d015beap-59},
    {0x1.70945a96f12c4p-1, -0x1.fc6bf2c69de0ep-55, 0x1.14ee9010d92c8p-5, 0x1.cc213ba5eda9cp-59},
    {0x1.81719c62ec68ep-1, -0x1.8dcc074b35fccp-55, 0x1.069e593b92370p-5, 0x1.de238e8b6cb54p-59},
    {0x1.9164d335425e2p-1, 0x1.9bd63e9682245p-56, 0x1.ef5d57d53b4a2p-6, 0x1.0b696b7532f23p-60},
    {0x1.a0644fb6d8db8p-1, 0x1.86ee2951ec9e2p-56, 0x1.d05133c3af937p-6, -0x1.fd0e9bcc1be0fp-64},
    {0x1.ae66f68eedbc6p-1, 0x1.b09457655e6bbp-55, 0x1.b02b2071c0c2dp-6, 0x1.fe20d30ba424dp-63},
    {0x1.bb6445eadae2cp-1, 0x1.cc03c1cfcb7b9p-55, 0x1.8efea346845b4p-6, -0x1.512cd68b2f9d5p-61},
    {0x1.c7545aa8c0dadp-1, -0x1.3a867481c3ba2p-55, 0x1.6cdfe10bba3c0p-6, 0x1.a61312c5212b3p-61},
    {0x1.d22ff5221288ap-1, -0x1.5a6e89c0cc78bp-56, 0x1.49e391bd2145fp-6, 0x1.c49dc47ac67acp-62},
    {0x1.dbf07d935a5afp-1, 0x1.d2326373d1eb5p-58, 0x1.261ef40a7a2e7p-6, -0x1.086176364dc3fp-63},
    {0x1.e490081f2891bp-1, 0x1.d4f077a3f6131p-55, 0x1.01a7c0a5c987fp-6, 0x1.6176c1c637d9ep-60},
    {0x1.ec09586b58faap-1, -0x1.cdbd1201bcd21p-55, 0x1.b9283b35dfa9cp-7, -0x1.d3d33afbf810fp-68},
    {0x1.f257e4db5aabcp-1, -0x1.b1af7e5a961e6p-57, 0x1.6df524de84e24p-7, 0x1.77a41c69937f8p-61},
    {0x1.f777d976cfadap-1, -0x1.7323efdbd8ae8p-56, 0x1.21e400109d479p-7, 0x1.d105051ca5738p-61},
    {0x1.fb661ac8c85a9p-1, 0x1.3792807502868p-55, 0x1.aa46b24145a02p-8, 0x1.8b5f0a3c07d65p-64},
    {0x1.fe204ab274ecdp-1, -0x1.db128bceb44b3p-55, 0x1.0fc7ac3ac322fp-8, -0x1.56749cdc617f8p-62},
    {0x1.ffa4e911f7533p-1, -0x1.1d93bde1341cbp-55, 0x1.d379f1846042ep-10, -0x1.4e6dca8a84769p-64},
}};

}  // namespace phrame
