// SPDX-License-Identifier: MIT
// Every evaluator. One line here makes it exist everywhere: accuracy, timing, tests, `list`, the report, the README.
#pragma once

#include "core/evaluate/homogeneous.hpp"
#include "core/evaluate/local.hpp"
#include "core/evaluate/methods/barycentric_chebyshev.hpp"
#include "core/evaluate/methods/barycentric_uniform.hpp"
#include "core/evaluate/methods/compensated_de_casteljau.hpp"
#include "core/evaluate/methods/compensated_horner.hpp"
#include "core/evaluate/methods/compensated_horner_k.hpp"
#include "core/evaluate/methods/compensated_volk_schumaker.hpp"
#include "core/evaluate/methods/correctly_rounded.hpp"
#include "core/evaluate/methods/correctly_rounded_power.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"
#include "core/evaluate/methods/de_casteljau_farin.hpp"
#include "core/evaluate/methods/de_casteljau_fixed_point.hpp"
#include "core/evaluate/methods/de_casteljau_fma.hpp"
#include "core/evaluate/methods/de_casteljau_lerp.hpp"
#include "core/evaluate/methods/de_casteljau_lerp_fma.hpp"
#include "core/evaluate/methods/de_casteljau_two_sided.hpp"
#include "core/evaluate/methods/direct.hpp"
#include "core/evaluate/methods/direct_pow.hpp"
#include "core/evaluate/methods/estrin.hpp"
#include "core/evaluate/methods/horner.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"
#include "core/evaluate/methods/horner_bernstein_fma.hpp"
#include "core/evaluate/methods/horner_centered.hpp"
#include "core/evaluate/methods/horner_corrected.hpp"
#include "core/evaluate/methods/horner_dd.hpp"
#include "core/evaluate/methods/horner_fma.hpp"
#include "core/evaluate/methods/local_or_bernstein.hpp"
#include "core/evaluate/methods/power_sum.hpp"
#include "core/evaluate/methods/seiler.hpp"
#include "core/evaluate/methods/volk_schumaker.hpp"
#include "core/evaluate/methods/wang_ball.hpp"
#include "core/evaluate/methods/wozny_chudy.hpp"
#include "core/evaluate/methods/wozny_chudy_positive.hpp"
#include "core/evaluate/methods/wozny_chudy_positive_rational.hpp"
#include "core/evaluate/methods/wozny_chudy_rational.hpp"

namespace bezierbench {

using Evaluators = TypeList<Direct,                             //
                            DirectPow,                          //
                            DeCasteljau,                        //
                            DeCasteljauFma,                     //
                            DeCasteljauLerp,                    //
                            DeCasteljauLerpFma,                 //
                            DeCasteljauTwoSided,                //
                            DeCasteljauFixedPoint,              //
                            CompensatedDeCasteljau,             //
                            CompensatedDeCasteljauK3,           //
                            CompensatedDeCasteljauK4,           //
                            HornerBernstein,                    //
                            HornerBernsteinFma,                 //
                            VolkSchumaker,                      //
                            CompensatedVolkSchumaker,           //
                            CorrectlyRounded,                   //
                            WoznyChudy,                         //
                            WoznyChudyPositive,                 //
                            BarycentricChebyshev,               //
                            BarycentricUniform,                 //
                            WangBall,                           //
                            Seiler,                             //
                            Local<DeCasteljau>,                 //
                            Local<HornerBernsteinFma>,          //
                            LocalOrBernstein::Plain,            //
                            LocalOrBernstein::Corrected,        //
                            LocalOrBernstein,                   //
                            PowerSum,                           //
                            Horner,                             //
                            HornerFma,                          //
                            HornerCorrected,                    //
                            CompensatedHorner,                  //
                            CompensatedHornerK3,                //
                            CompensatedHornerK4,                //
                            HornerDoubleDouble,                 //
                            CorrectlyRoundedPower,              //
                            HornerCentered,                     //
                            Estrin,                             //
                            Homogeneous<Direct>,                //
                            Homogeneous<DeCasteljau>,           //
                            Homogeneous<DeCasteljauTwoSided>,   //
                            DeCasteljauFarin,                   //
                            Homogeneous<HornerBernstein>,       //
                            Homogeneous<VolkSchumaker>,         //
                            WoznyChudyRational,                 //
                            WoznyChudyPositiveRational,         //
                            Homogeneous<BarycentricChebyshev>,  //
                            Homogeneous<BarycentricUniform>,    //
                            Homogeneous<WangBall>>;

}  // namespace bezierbench
