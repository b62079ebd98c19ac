function J(n,e={},...t){let[i,...s]=n.split("."),r=document.createElement(i);s.length>0&&(r.className=s.join(" "));for(let[a,o]of Object.entries(e))a.startsWith("on")&&typeof o=="function"?r.addEventListener(a.slice(2),o):a in r&&!a.startsWith("aria")&&a!=="for"?r[a]=o:o!==void 0&&o!==!1&&r.setAttribute(a,String(o));return r.append(...t.filter(a=>a!=null)),r}function kn(n,...e){return J("label.row",{},J("span.name",{},n),J("span.controls",{},...e))}function si(n,e,t,i=""){let s=J("input",{type:"checkbox",checked:e,onchange:()=>t(s.checked)});return J("label.check",{title:i},s,J("span",{},n))}function di(n,e,t,i){let s=J("select",{onchange:()=>t(s.value),"aria-label":i});for(let[r,a]of n)s.append(J("option",{value:r},a));return s.value=e,s}function Gr(n,e){let t=URL.createObjectURL(n),i=J("a",{href:t,download:e});document.body.append(i),i.click(),i.remove(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}var Ew={play:"M7 4l13 8-13 8z",pause:"M6 4h4v16H6zM14 4h4v16h-4z",first:"M6 5h2v14H6zM20 5v14L9 12z",last:"M16 5h2v14h-2zM4 5v14l11-7z",back:"M17 5v14L7 12z",next:"M7 5v14l10-7z",fit:"M4 9V4h5v2H6v3zM15 4h5v5h-2V6h-3zM4 15h2v3h3v2H4zM18 15h2v5h-5v-2h3z",menu:"M4 6h16v2H4zM4 11h16v2H4zM4 16h16v2H4z",theme:"M12 3a9 9 0 1 0 9 9 7 7 0 0 1-9-9z",help:"M11 17h2v2h-2zM12 4a5 5 0 0 0-5 5h2a3 3 0 1 1 4.6 2.5C12.2 12.4 11 13.3 11 15h2c0-1 .7-1.500 1.700-2.200A5 5 0 0 0 12 4z",camera:"M9 5l-1.500 2H4v12h16V7h-3.500L15 5zM12 9.500a3.500 3.500 0 1 1 0 7 3.500 3.500 0 0 1 0-7z",plots:"M4 4h2v14h14v2H4zM8 15l4-6 3 3 4-7 1.600 1L15.500 15l-3-3L9.600 16z",loop:"M7 7h10v3l4-4-4-4v3H5v6h2zM17 17H7v-3l-4 4 4 4v-3h12v-6h-2z"};function ip(n){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Ew[n]??""),e.append(t),e}function rs(n,e,t){return J("button.icon",{title:e,"aria-label":e,onclick:t,type:"button"},ip(n))}var pi=Uint8Array,Xi=Uint16Array,cp=Int32Array,hp=new pi([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),up=new pi([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),$0=new pi([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Q0=function(n,e){for(var t=new Xi(31),i=0;i<31;++i)t[i]=e+=1<<n[i-1];for(var s=new cp(t[30]),i=1;i<30;++i)for(var r=t[i];r<t[i+1];++r)s[r]=r-t[i]<<5|i;return{b:t,r:s}},ev=Q0(hp,2),Tw=ev.b,rp=ev.r;Tw[28]=258,rp[258]=28;var tv=Q0(up,0),aD=tv.b,q0=tv.r,ap=new Xi(32768);for(Nt=0;Nt<32768;++Nt)lr=(Nt&43690)>>1|(Nt&21845)<<1,lr=(lr&52428)>>2|(lr&13107)<<2,lr=(lr&61680)>>4|(lr&3855)<<4,ap[Nt]=((lr&65280)>>8|(lr&255)<<8)>>1;var lr,Nt,bl=(function(n,e,t){for(var i=n.length,s=0,r=new Xi(e);s<i;++s)n[s]&&++r[n[s]-1];var a=new Xi(e);for(s=1;s<e;++s)a[s]=a[s-1]+r[s-1]<<1;var o;if(t){o=new Xi(1<<e);var l=15-e;for(s=0;s<i;++s)if(n[s])for(var c=s<<4|n[s],h=e-n[s],u=a[n[s]-1]++<<h,f=u|(1<<h)-1;u<=f;++u)o[ap[u]>>l]=c}else for(o=new Xi(i),s=0;s<i;++s)n[s]&&(o[s]=ap[a[n[s]-1]++]>>15-n[s]);return o}),ua=new pi(288);for(Nt=0;Nt<144;++Nt)ua[Nt]=8;var Nt;for(Nt=144;Nt<256;++Nt)ua[Nt]=9;var Nt;for(Nt=256;Nt<280;++Nt)ua[Nt]=7;var Nt;for(Nt=280;Nt<288;++Nt)ua[Nt]=8;var Nt,ih=new pi(32);for(Nt=0;Nt<32;++Nt)ih[Nt]=5;var Nt,Aw=bl(ua,9,0);var Rw=bl(ih,5,0);var nv=function(n){return(n+7)/8|0},iv=function(n,e,t){return(e==null||e<0)&&(e=0),(t==null||t>n.length)&&(t=n.length),new pi(n.subarray(e,t))};var Cw=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],sh=function(n,e,t){var i=new Error(e||Cw[n]);if(i.code=n,Error.captureStackTrace&&Error.captureStackTrace(i,sh),!t)throw i;return i};var cr=function(n,e,t){t<<=e&7;var i=e/8|0;n[i]|=t,n[i+1]|=t>>8},vl=function(n,e,t){t<<=e&7;var i=e/8|0;n[i]|=t,n[i+1]|=t>>8,n[i+2]|=t>>16},sp=function(n,e){for(var t=[],i=0;i<n.length;++i)n[i]&&t.push({s:i,f:n[i]});var s=t.length,r=t.slice();if(!s)return{t:rv,l:0};if(s==1){var a=new pi(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(T,M){return T.f-M.f}),t.push({s:-1,f:25001});var o=t[0],l=t[1],c=0,h=1,u=2;for(t[0]={s:-1,f:o.f+l.f,l:o,r:l};h!=s-1;)o=t[t[c].f<t[u].f?c++:u++],l=t[c!=h&&t[c].f<t[u].f?c++:u++],t[h++]={s:-1,f:o.f+l.f,l:o,r:l};for(var f=r[0].s,i=1;i<s;++i)r[i].s>f&&(f=r[i].s);var d=new Xi(f+1),p=op(t[h-1],d,0);if(p>e){var i=0,v=0,m=p-e,g=1<<m;for(r.sort(function(M,b){return d[b.s]-d[M.s]||M.f-b.f});i<s;++i){var y=r[i].s;if(d[y]>e)v+=g-(1<<p-d[y]),d[y]=e;else break}for(v>>=m;v>0;){var _=r[i].s;d[_]<e?v-=1<<e-d[_]++-1:++i}for(;i>=0&&v;--i){var x=r[i].s;d[x]==e&&(--d[x],++v)}p=e}return{t:new pi(d),l:p}},op=function(n,e,t){return n.s==-1?Math.max(op(n.l,e,t+1),op(n.r,e,t+1)):e[n.s]=t},Y0=function(n){for(var e=n.length;e&&!n[--e];);for(var t=new Xi(++e),i=0,s=n[0],r=1,a=function(l){t[i++]=l},o=1;o<=e;++o)if(n[o]==s&&o!=e)++r;else{if(!s&&r>2){for(;r>138;r-=138)a(32754);r>2&&(a(r>10?r-11<<5|28690:r-3<<5|12305),r=0)}else if(r>3){for(a(s),--r;r>6;r-=6)a(8304);r>2&&(a(r-3<<5|8208),r=0)}for(;r--;)a(s);r=1,s=n[o]}return{c:t.subarray(0,i),n:e}},yl=function(n,e){for(var t=0,i=0;i<e.length;++i)t+=n[i]*e[i];return t},sv=function(n,e,t){var i=t.length,s=nv(e+2);n[s]=i&255,n[s+1]=i>>8,n[s+2]=n[s]^255,n[s+3]=n[s+1]^255;for(var r=0;r<i;++r)n[s+r+4]=t[r];return(s+4+i)*8},j0=function(n,e,t,i,s,r,a,o,l,c,h){cr(e,h++,t),++s[256];for(var u=sp(s,15),f=u.t,d=u.l,p=sp(r,15),v=p.t,m=p.l,g=Y0(f),y=g.c,_=g.n,x=Y0(v),T=x.c,M=x.n,b=new Xi(19),S=0;S<y.length;++S)++b[y[S]&31];for(var S=0;S<T.length;++S)++b[T[S]&31];for(var C=sp(b,7),I=C.t,L=C.l,O=19;O>4&&!I[$0[O-1]];--O);var z=c+5<<3,U=yl(s,ua)+yl(r,ih)+a,G=yl(s,f)+yl(r,v)+a+14+3*O+yl(b,I)+2*b[16]+3*b[17]+7*b[18];if(l>=0&&z<=U&&z<=G)return sv(e,h,n.subarray(l,l+c));var q,H,le,j;if(cr(e,h,1+(G<U)),h+=2,G<U){q=bl(f,d,0),H=f,le=bl(v,m,0),j=v;var te=bl(I,L,0);cr(e,h,_-257),cr(e,h+5,M-1),cr(e,h+10,O-4),h+=14;for(var S=0;S<O;++S)cr(e,h+3*S,I[$0[S]]);h+=3*O;for(var ne=[y,T],pe=0;pe<2;++pe)for(var he=ne[pe],S=0;S<he.length;++S){var Q=he[S]&31;cr(e,h,te[Q]),h+=I[Q],Q>15&&(cr(e,h,he[S]>>5&127),h+=he[S]>>12)}}else q=Aw,H=ua,le=Rw,j=ih;for(var S=0;S<o;++S){var fe=i[S];if(fe>255){var Q=fe>>18&31;vl(e,h,q[Q+257]),h+=H[Q+257],Q>7&&(cr(e,h,fe>>23&31),h+=hp[Q]);var ve=fe&31;vl(e,h,le[ve]),h+=j[ve],ve>3&&(vl(e,h,fe>>5&8191),h+=up[ve])}else vl(e,h,q[fe]),h+=H[fe]}return vl(e,h,q[256]),h+H[256]},Pw=new cp([65540,131080,131088,131104,262176,1048704,1048832,2114560,2117632]),rv=new pi(0),Iw=function(n,e,t,i,s,r){var a=r.z||n.length,o=new pi(i+a+5*(1+Math.ceil(a/7e3))+s),l=o.subarray(i,o.length-s),c=r.l,h=(r.r||0)&7;if(e){h&&(l[0]=r.r>>3);for(var u=Pw[e-1],f=u>>13,d=u&8191,p=(1<<t)-1,v=r.p||new Xi(32768),m=r.h||new Xi(p+1),g=Math.ceil(t/3),y=2*g,_=function(Qe){return(n[Qe]^n[Qe+1]<<g^n[Qe+2]<<y)&p},x=new cp(25e3),T=new Xi(288),M=new Xi(32),b=0,S=0,C=r.i||0,I=0,L=r.w||0,O=0;C+2<a;++C){var z=_(C),U=C&32767,G=m[z];if(v[U]=G,m[z]=U,L<=C){var q=a-C;if((b>7e3||I>24576)&&(q>423||!c)){h=j0(n,l,0,x,T,M,S,I,O,C-O,h),I=b=S=0,O=C;for(var H=0;H<286;++H)T[H]=0;for(var H=0;H<30;++H)M[H]=0}var le=2,j=0,te=d,ne=U-G&32767;if(q>2&&z==_(C-ne))for(var pe=Math.min(f,q)-1,he=Math.min(32767,C),Q=Math.min(258,q);ne<=he&&--te&&U!=G;){if(n[C+le]==n[C+le-ne]){for(var fe=0;fe<Q&&n[C+fe]==n[C+fe-ne];++fe);if(fe>le){if(le=fe,j=ne,fe>pe)break;for(var ve=Math.min(ne,fe-2),Ee=0,H=0;H<ve;++H){var be=C-ne+H&32767,Xe=v[be],ot=be-Xe&32767;ot>Ee&&(Ee=ot,G=be)}}}U=G,G=v[U],ne+=U-G&32767}if(j){x[I++]=268435456|rp[le]<<18|q0[j];var Ge=rp[le]&31,dt=q0[j]&31;S+=hp[Ge]+up[dt],++T[257+Ge],++M[dt],L=C+le,++b}else x[I++]=n[C],++T[n[C]]}}for(C=Math.max(C,L);C<a;++C)x[I++]=n[C],++T[n[C]];h=j0(n,l,c,x,T,M,S,I,O,C-O,h),c||(r.r=h&7|l[h/8|0]<<3,h-=7,r.h=m,r.p=v,r.i=C,r.w=L)}else{for(var C=r.w||0;C<a+c;C+=65535){var ut=C+65535;ut>=a&&(l[h/8|0]=c,ut=a),h=sv(l,h+1,n.subarray(C,ut))}r.i=a}return iv(o,0,i+nv(h)+s)},Lw=(function(){for(var n=new Int32Array(256),e=0;e<256;++e){for(var t=e,i=9;--i;)t=(t&1&&-306674912)^t>>>1;n[e]=t}return n})(),Dw=function(){var n=-1;return{p:function(e){for(var t=n,i=0;i<e.length;++i)t=Lw[t&255^e[i]]^t>>>8;n=t},d:function(){return~n}}};var Nw=function(n,e,t,i,s){if(!s&&(s={l:1},e.dictionary)){var r=e.dictionary.subarray(-32768),a=new pi(r.length+n.length);a.set(r),a.set(n,r.length),n=a,s.w=r.length}return Iw(n,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(n.length)))*1.5):20:12+e.mem,t,i,s)},av=function(n,e){var t={};for(var i in n)t[i]=n[i];for(var i in e)t[i]=e[i];return t};var ri=function(n,e,t){for(;t;++e)n[e]=t,t>>>=8};function Uw(n,e){return Nw(n,e||{},0,0)}var ov=function(n,e,t,i){for(var s in n){var r=n[s],a=e+s,o=i;Array.isArray(r)&&(o=av(i,r[1]),r=r[0]),ArrayBuffer.isView(r)?t[a]=[r,o]:(t[a+="/"]=[new pi(0),o],ov(r,a,t,i))}},Z0=typeof TextEncoder<"u"&&new TextEncoder,Fw=typeof TextDecoder<"u"&&new TextDecoder,Ow=0;try{Fw.decode(rv,{stream:!0}),Ow=1}catch{}function J0(n,e){if(e){for(var t=new pi(n.length),i=0;i<n.length;++i)t[i]=n.charCodeAt(i);return t}if(Z0)return Z0.encode(n);for(var s=n.length,r=new pi(n.length+(n.length>>1)),a=0,o=function(h){r[a++]=h},i=0;i<s;++i){if(a+5>r.length){var l=new pi(a+8+(s-i<<1));l.set(r),r=l}var c=n.charCodeAt(i);c<128||e?o(c):c<2048?(o(192|c>>6),o(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|n.charCodeAt(++i)&1023,o(240|c>>18),o(128|c>>12&63),o(128|c>>6&63),o(128|c&63)):(o(224|c>>12),o(128|c>>6&63),o(128|c&63))}return iv(r,0,a)}var lp=function(n){var e=0;if(n)for(var t in n){var i=n[t].length;i>65535&&sh(9),e+=i+4}return e},K0=function(n,e,t,i,s,r,a,o){var l=i.length,c=t.extra,h=o&&o.length,u=lp(c);ri(n,e,a!=null?33639248:67324752),e+=4,a!=null&&(n[e++]=20,n[e++]=t.os),n[e]=20,e+=2,n[e++]=t.flag<<1|(r<0&&8),n[e++]=s&&8,n[e++]=t.compression&255,n[e++]=t.compression>>8;var f=new Date(t.mtime==null?Date.now():t.mtime),d=f.getFullYear()-1980;if((d<0||d>119)&&sh(10),ri(n,e,d<<25|f.getMonth()+1<<21|f.getDate()<<16|f.getHours()<<11|f.getMinutes()<<5|f.getSeconds()>>1),e+=4,r!=-1&&(ri(n,e,t.crc),ri(n,e+4,r<0?-r-2:r),ri(n,e+8,t.size)),ri(n,e+12,l),ri(n,e+14,u),e+=16,a!=null&&(ri(n,e,h),ri(n,e+6,t.attrs),ri(n,e+10,a),e+=14),n.set(i,e),e+=l,u)for(var p in c){var v=c[p],m=v.length;ri(n,e,+p),ri(n,e+2,m),n.set(v,e+4),e+=4+m}return h&&(n.set(o,e),e+=h),e},kw=function(n,e,t,i,s){ri(n,e,101010256),ri(n,e+8,t),ri(n,e+10,t),ri(n,e+12,i),ri(n,e+16,s)};function lv(n,e){e||(e={});var t={},i=[];ov(n,"",t,e);var s=0,r=0;for(var a in t){var o=t[a],l=o[0],c=o[1],h=c.level==0?0:8,u=J0(a),f=u.length,d=c.comment,p=d&&J0(d),v=p&&p.length,m=lp(c.extra);f>65535&&sh(11);var g=h?Uw(l,c):l,y=g.length,_=Dw();_.p(l),i.push(av(c,{size:l.length,crc:_.d(),c:g,f:u,m:p,u:f!=a.length||p&&d.length!=v,o:s,compression:h})),s+=30+f+m+y,r+=76+2*(f+m)+(v||0)+y}for(var x=new pi(r+22),T=s,M=r-s,b=0;b<i.length;++b){var u=i[b];K0(x,u.o,u,u.f,u.u,u.c.length);var S=30+u.f.length+lp(u.extra);x.set(u.c,u.o+S),K0(x,s,u,u.f,u.u,u.c.length,u.o,u.m),s+=16+S+(u.m?u.m.length:0)}return kw(x,s,i.length,M,T),x}function no(n,e,t){n.prototype=e.prototype=t,t.constructor=n}function wl(n,e){var t=Object.create(n.prototype);for(var i in e)t[i]=e[i];return t}function Wr(){}var ma=.7,to=1/ma,Qa="\\s*([+-]?\\d+)\\s*",xl="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)\\s*",ks="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)%\\s*",Bw=/^#([0-9a-f]{3,8})$/,zw=new RegExp(`^rgb\\(${Qa},${Qa},${Qa}\\)$`),Hw=new RegExp(`^rgb\\(${ks},${ks},${ks}\\)$`),Vw=new RegExp(`^rgba\\(${Qa},${Qa},${Qa},${xl}\\)$`),Gw=new RegExp(`^rgba\\(${ks},${ks},${ks},${xl}\\)$`),Ww=new RegExp(`^hsl\\(${xl},${ks},${ks}\\)$`),Xw=new RegExp(`^hsla\\(${xl},${ks},${ks},${xl}\\)$`),cv={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074};no(Wr,ch,{copy(n){return Object.assign(new this.constructor,this,n)},displayable(){return this.rgb().displayable()},hex:hv,formatHex:hv,formatHex8:$w,formatHsl:qw,formatRgb:uv,toString:uv});function hv(){return this.rgb().formatHex()}function $w(){return this.rgb().formatHex8()}function qw(){return xv(this).formatHsl()}function uv(){return this.rgb().formatRgb()}function ch(n){var e,t;return n=(n+"").trim().toLowerCase(),(e=Bw.exec(n))?(t=e[1].length,e=parseInt(e[1],16),t===6?fv(e):t===3?new Zn(e>>8&15|e>>4&240,e>>4&15|e&240,(e&15)<<4|e&15,1):t===8?rh(e>>24&255,e>>16&255,e>>8&255,(e&255)/255):t===4?rh(e>>12&15|e>>8&240,e>>8&15|e>>4&240,e>>4&15|e&240,((e&15)<<4|e&15)/255):null):(e=zw.exec(n))?new Zn(e[1],e[2],e[3],1):(e=Hw.exec(n))?new Zn(e[1]*255/100,e[2]*255/100,e[3]*255/100,1):(e=Vw.exec(n))?rh(e[1],e[2],e[3],e[4]):(e=Gw.exec(n))?rh(e[1]*255/100,e[2]*255/100,e[3]*255/100,e[4]):(e=Ww.exec(n))?mv(e[1],e[2]/100,e[3]/100,1):(e=Xw.exec(n))?mv(e[1],e[2]/100,e[3]/100,e[4]):cv.hasOwnProperty(n)?fv(cv[n]):n==="transparent"?new Zn(NaN,NaN,NaN,0):null}function fv(n){return new Zn(n>>16&255,n>>8&255,n&255,1)}function rh(n,e,t,i){return i<=0&&(n=e=t=NaN),new Zn(n,e,t,i)}function vp(n){return n instanceof Wr||(n=ch(n)),n?(n=n.rgb(),new Zn(n.r,n.g,n.b,n.opacity)):new Zn}function ga(n,e,t,i){return arguments.length===1?vp(n):new Zn(n,e,t,i??1)}function Zn(n,e,t,i){this.r=+n,this.g=+e,this.b=+t,this.opacity=+i}no(Zn,ga,wl(Wr,{brighter(n){return n=n==null?to:Math.pow(to,n),new Zn(this.r*n,this.g*n,this.b*n,this.opacity)},darker(n){return n=n==null?ma:Math.pow(ma,n),new Zn(this.r*n,this.g*n,this.b*n,this.opacity)},rgb(){return this},clamp(){return new Zn(da(this.r),da(this.g),da(this.b),oh(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.b<255.5&&0<=this.opacity&&this.opacity<=1},hex:dv,formatHex:dv,formatHex8:Yw,formatRgb:pv,toString:pv}));function dv(){return`#${fa(this.r)}${fa(this.g)}${fa(this.b)}`}function Yw(){return`#${fa(this.r)}${fa(this.g)}${fa(this.b)}${fa((isNaN(this.opacity)?1:this.opacity)*255)}`}function pv(){let n=oh(this.opacity);return`${n===1?"rgb(":"rgba("}${da(this.r)}, ${da(this.g)}, ${da(this.b)}${n===1?")":`, ${n})`}`}function oh(n){return isNaN(n)?1:Math.max(0,Math.min(1,n))}function da(n){return Math.max(0,Math.min(255,Math.round(n)||0))}function fa(n){return n=da(n),(n<16?"0":"")+n.toString(16)}function mv(n,e,t,i){return i<=0?n=e=t=NaN:t<=0||t>=1?n=e=NaN:e<=0&&(n=NaN),new vs(n,e,t,i)}function xv(n){if(n instanceof vs)return new vs(n.h,n.s,n.l,n.opacity);if(n instanceof Wr||(n=ch(n)),!n)return new vs;if(n instanceof vs)return n;n=n.rgb();var e=n.r/255,t=n.g/255,i=n.b/255,s=Math.min(e,t,i),r=Math.max(e,t,i),a=NaN,o=r-s,l=(r+s)/2;return o?(e===r?a=(t-i)/o+(t<i)*6:t===r?a=(i-e)/o+2:a=(e-t)/o+4,o/=l<.5?r+s:2-r-s,a*=60):o=l>0&&l<1?0:a,new vs(a,o,l,n.opacity)}function hh(n,e,t,i){return arguments.length===1?xv(n):new vs(n,e,t,i??1)}function vs(n,e,t,i){this.h=+n,this.s=+e,this.l=+t,this.opacity=+i}no(vs,hh,wl(Wr,{brighter(n){return n=n==null?to:Math.pow(to,n),new vs(this.h,this.s,this.l*n,this.opacity)},darker(n){return n=n==null?ma:Math.pow(ma,n),new vs(this.h,this.s,this.l*n,this.opacity)},rgb(){var n=this.h%360+(this.h<0)*360,e=isNaN(n)||isNaN(this.s)?0:this.s,t=this.l,i=t+(t<.5?t:1-t)*e,s=2*t-i;return new Zn(fp(n>=240?n-240:n+120,s,i),fp(n,s,i),fp(n<120?n+240:n-120,s,i),this.opacity)},clamp(){return new vs(gv(this.h),ah(this.s),ah(this.l),oh(this.opacity))},displayable(){return(0<=this.s&&this.s<=1||isNaN(this.s))&&0<=this.l&&this.l<=1&&0<=this.opacity&&this.opacity<=1},formatHsl(){let n=oh(this.opacity);return`${n===1?"hsl(":"hsla("}${gv(this.h)}, ${ah(this.s)*100}%, ${ah(this.l)*100}%${n===1?")":`, ${n})`}`}}));function gv(n){return n=(n||0)%360,n<0?n+360:n}function ah(n){return Math.max(0,Math.min(1,n||0))}function fp(n,e,t){return(n<60?e+(t-e)*n/60:n<180?t:n<240?e+(t-e)*(240-n)/60:e)*255}var _v=Math.PI/180,wv=180/Math.PI,lh=18,Sv=.96422,Mv=1,Ev=.82521,Tv=4/29,eo=6/29,Av=3*eo*eo,jw=eo*eo*eo;function Rv(n){if(n instanceof Bs)return new Bs(n.l,n.a,n.b,n.opacity);if(n instanceof hr)return Pv(n);n instanceof Zn||(n=vp(n));var e=gp(n.r),t=gp(n.g),i=gp(n.b),s=dp((.2225045*e+.7168786*t+.0606169*i)/Mv),r,a;return e===t&&t===i?r=a=s:(r=dp((.4360747*e+.3850649*t+.1430804*i)/Sv),a=dp((.0139322*e+.0971045*t+.7141733*i)/Ev)),new Bs(116*s-16,500*(r-s),200*(s-a),n.opacity)}function Cv(n,e,t,i){return arguments.length===1?Rv(n):new Bs(n,e,t,i??1)}function Bs(n,e,t,i){this.l=+n,this.a=+e,this.b=+t,this.opacity=+i}no(Bs,Cv,wl(Wr,{brighter(n){return new Bs(this.l+lh*(n??1),this.a,this.b,this.opacity)},darker(n){return new Bs(this.l-lh*(n??1),this.a,this.b,this.opacity)},rgb(){var n=(this.l+16)/116,e=isNaN(this.a)?n:n+this.a/500,t=isNaN(this.b)?n:n-this.b/200;return e=Sv*pp(e),n=Mv*pp(n),t=Ev*pp(t),new Zn(mp(3.1338561*e-1.6168667*n-.4906146*t),mp(-.9787684*e+1.9161415*n+.033454*t),mp(.0719453*e-.2289914*n+1.4052427*t),this.opacity)}}));function dp(n){return n>jw?Math.pow(n,1/3):n/Av+Tv}function pp(n){return n>eo?n*n*n:Av*(n-Tv)}function mp(n){return 255*(n<=.0031308?12.92*n:1.055*Math.pow(n,1/2.4)-.055)}function gp(n){return(n/=255)<=.04045?n/12.92:Math.pow((n+.055)/1.055,2.4)}function Zw(n){if(n instanceof hr)return new hr(n.h,n.c,n.l,n.opacity);if(n instanceof Bs||(n=Rv(n)),n.a===0&&n.b===0)return new hr(NaN,0<n.l&&n.l<100?0:NaN,n.l,n.opacity);var e=Math.atan2(n.b,n.a)*wv;return new hr(e<0?e+360:e,Math.sqrt(n.a*n.a+n.b*n.b),n.l,n.opacity)}function uh(n,e,t,i){return arguments.length===1?Zw(n):new hr(n,e,t,i??1)}function hr(n,e,t,i){this.h=+n,this.c=+e,this.l=+t,this.opacity=+i}function Pv(n){if(isNaN(n.h))return new Bs(n.l,0,0,n.opacity);var e=n.h*_v;return new Bs(n.l,Math.cos(e)*n.c,Math.sin(e)*n.c,n.opacity)}no(hr,uh,wl(Wr,{brighter(n){return new hr(this.h,this.c,this.l+lh*(n??1),this.opacity)},darker(n){return new hr(this.h,this.c,this.l-lh*(n??1),this.opacity)},rgb(){return Pv(this).rgb()}}));var Iv=-.14861,yp=1.78277,bp=-.29227,fh=-.90649,_l=1.97294,vv=_l*fh,yv=_l*yp,bv=yp*bp-fh*Iv;function Jw(n){if(n instanceof pa)return new pa(n.h,n.s,n.l,n.opacity);n instanceof Zn||(n=vp(n));var e=n.r/255,t=n.g/255,i=n.b/255,s=(bv*i+vv*e-yv*t)/(bv+vv-yv),r=i-s,a=(_l*(t-s)-bp*r)/fh,o=Math.sqrt(a*a+r*r)/(_l*s*(1-s)),l=o?Math.atan2(a,r)*wv-120:NaN;return new pa(l<0?l+360:l,o,s,n.opacity)}function as(n,e,t,i){return arguments.length===1?Jw(n):new pa(n,e,t,i??1)}function pa(n,e,t,i){this.h=+n,this.s=+e,this.l=+t,this.opacity=+i}no(pa,as,wl(Wr,{brighter(n){return n=n==null?to:Math.pow(to,n),new pa(this.h,this.s,this.l*n,this.opacity)},darker(n){return n=n==null?ma:Math.pow(ma,n),new pa(this.h,this.s,this.l*n,this.opacity)},rgb(){var n=isNaN(this.h)?0:(this.h+120)*_v,e=+this.l,t=isNaN(this.s)?0:this.s*e*(1-e),i=Math.cos(n),s=Math.sin(n);return new Zn(255*(e+t*(Iv*i+yp*s)),255*(e+t*(bp*i+fh*s)),255*(e+t*(_l*i)),this.opacity)}}));function Nv(n,e,t,i,s){var r=n*n,a=r*n;return((1-3*n+3*r-a)*e+(4-6*r+3*a)*t+(1+3*n+3*r-3*a)*i+a*s)/6}function Kw(n){var e=n.length-1;return function(t){var i=t<=0?t=0:t>=1?(t=1,e-1):Math.floor(t*e),s=n[i],r=n[i+1],a=i>0?n[i-1]:2*s-r,o=i<e-1?n[i+2]:2*r-s;return Nv((t-i/e)*e,a,s,r,o)}}function Qw(n){var e=n.length;return function(t){var i=Math.floor(((t%=1)<0?++t:t)*e),s=n[(i+e-1)%e],r=n[i%e],a=n[(i+1)%e],o=n[(i+2)%e];return Nv((t-i/e)*e,s,r,a,o)}}var _p=n=>()=>n;function Uv(n,e){return function(t){return n+t*e}}function eS(n,e,t){return n=Math.pow(n,t),e=Math.pow(e,t)-n,t=1/t,function(i){return Math.pow(n+i*e,t)}}function wp(n,e){var t=e-n;return t?Uv(n,t>180||t<-180?t-360*Math.round(t/360):t):_p(isNaN(n)?e:n)}function tS(n){return(n=+n)==1?Di:function(e,t){return t-e?eS(e,t,n):_p(isNaN(e)?t:e)}}function Di(n,e){var t=e-n;return t?Uv(n,t):_p(isNaN(n)?e:n)}var hD=(function n(e){var t=tS(e);function i(s,r){var a=t((s=ga(s)).r,(r=ga(r)).r),o=t(s.g,r.g),l=t(s.b,r.b),c=Di(s.opacity,r.opacity);return function(h){return s.r=a(h),s.g=o(h),s.b=l(h),s.opacity=c(h),s+""}}return i.gamma=n,i})(1);function Fv(n){return function(e){var t=e.length,i=new Array(t),s=new Array(t),r=new Array(t),a,o;for(a=0;a<t;++a)o=ga(e[a]),i[a]=o.r||0,s[a]=o.g||0,r[a]=o.b||0;return i=n(i),s=n(s),r=n(r),o.opacity=1,function(l){return o.r=i(l),o.g=s(l),o.b=r(l),o+""}}}var Ov=Fv(Kw),uD=Fv(Qw);function io(n,e){return n=+n,e=+e,function(t){return n*(1-t)+e*t}}var nS=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,fD=new RegExp(nS.source,"g");var Lv=180/Math.PI,xp={translateX:0,translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function kv(n,e,t,i,s,r){var a,o,l;return(a=Math.sqrt(n*n+e*e))&&(n/=a,e/=a),(l=n*t+e*i)&&(t-=n*l,i-=e*l),(o=Math.sqrt(t*t+i*i))&&(t/=o,i/=o,l/=o),n*i<e*t&&(n=-n,e=-e,l=-l,a=-a),{translateX:s,translateY:r,rotate:Math.atan2(e,n)*Lv,skewX:Math.atan(l)*Lv,scaleX:a,scaleY:o}}var dh;function iS(n){let e=new(typeof DOMMatrix=="function"?DOMMatrix:WebKitCSSMatrix)(n+"");return e.isIdentity?xp:kv(e.a,e.b,e.c,e.d,e.e,e.f)}function sS(n){return n==null||(dh||(dh=document.createElementNS("http://www.w3.org/2000/svg","g")),dh.setAttribute("transform",n),!(n=dh.transform.baseVal.consolidate()))?xp:(n=n.matrix,kv(n.a,n.b,n.c,n.d,n.e,n.f))}function Bv(n,e,t,i){function s(c){return c.length?c.pop()+" ":""}function r(c,h,u,f,d,p){if(c!==u||h!==f){var v=d.push("translate(",null,e,null,t);p.push({i:v-4,x:io(c,u)},{i:v-2,x:io(h,f)})}else(u||f)&&d.push("translate("+u+e+f+t)}function a(c,h,u,f){c!==h?(c-h>180?h+=360:h-c>180&&(c+=360),f.push({i:u.push(s(u)+"rotate(",null,i)-2,x:io(c,h)})):h&&u.push(s(u)+"rotate("+h+i)}function o(c,h,u,f){c!==h?f.push({i:u.push(s(u)+"skewX(",null,i)-2,x:io(c,h)}):h&&u.push(s(u)+"skewX("+h+i)}function l(c,h,u,f,d,p){if(c!==u||h!==f){var v=d.push(s(d)+"scale(",null,",",null,")");p.push({i:v-4,x:io(c,u)},{i:v-2,x:io(h,f)})}else(u!==1||f!==1)&&d.push(s(d)+"scale("+u+","+f+")")}return function(c,h){var u=[],f=[];return c=n(c),h=n(h),r(c.translateX,c.translateY,h.translateX,h.translateY,u,f),a(c.rotate,h.rotate,u,f),o(c.skewX,h.skewX,u,f),l(c.scaleX,c.scaleY,h.scaleX,h.scaleY,u,f),c=h=null,function(d){for(var p=-1,v=f.length,m;++p<v;)u[(m=f[p]).i]=m.x(d);return u.join("")}}}var dD=Bv(iS,"px, ","px)","deg)"),pD=Bv(sS,", ",")",")"),rS=1e-12;function Dv(n){return((n=Math.exp(n))+1/n)/2}function aS(n){return((n=Math.exp(n))-1/n)/2}function oS(n){return((n=Math.exp(2*n))-1)/(n+1)}var mD=(function n(e,t,i){function s(r,a){var o=r[0],l=r[1],c=r[2],h=a[0],u=a[1],f=a[2],d=h-o,p=u-l,v=d*d+p*p,m,g;if(v<rS)g=Math.log(f/c)/e,m=function(b){return[o+b*d,l+b*p,c*Math.exp(e*b*g)]};else{var y=Math.sqrt(v),_=(f*f-c*c+i*v)/(2*c*t*y),x=(f*f-c*c-i*v)/(2*f*t*y),T=Math.log(Math.sqrt(_*_+1)-_),M=Math.log(Math.sqrt(x*x+1)-x);g=(M-T)/e,m=function(b){var S=b*g,C=Dv(T),I=c/(t*y)*(C*oS(e*S+T)-aS(T));return[o+I*d,l+I*p,c*C/Dv(e*S+T)]}}return m.duration=Math.abs(g)*1e3*e/Math.SQRT2,m}return s.rho=function(r){var a=Math.max(.001,+r),o=a*a,l=o*o;return n(a,o,l)},s})(Math.SQRT2,2,4);function zv(n){return function(e,t){var i=n((e=hh(e)).h,(t=hh(t)).h),s=Di(e.s,t.s),r=Di(e.l,t.l),a=Di(e.opacity,t.opacity);return function(o){return e.h=i(o),e.s=s(o),e.l=r(o),e.opacity=a(o),e+""}}}var gD=zv(wp),vD=zv(Di);function Hv(n){return function(e,t){var i=n((e=uh(e)).h,(t=uh(t)).h),s=Di(e.c,t.c),r=Di(e.l,t.l),a=Di(e.opacity,t.opacity);return function(o){return e.h=i(o),e.c=s(o),e.l=r(o),e.opacity=a(o),e+""}}}var yD=Hv(wp),bD=Hv(Di);function Vv(n){return(function e(t){t=+t;function i(s,r){var a=n((s=as(s)).h,(r=as(r)).h),o=Di(s.s,r.s),l=Di(s.l,r.l),c=Di(s.opacity,r.opacity);return function(h){return s.h=a(h),s.s=o(h),s.l=l(Math.pow(h,t)),s.opacity=c(h),s+""}}return i.gamma=e,i})(1)}var xD=Vv(wp),ph=Vv(Di);function mt(n){for(var e=n.length/6|0,t=new Array(e),i=0;i<e;)t[i]="#"+n.slice(i*6,++i*6);return t}var MD=mt("1f77b4ff7f0e2ca02cd627289467bd8c564be377c27f7f7fbcbd2217becf"),ED=mt("7fc97fbeaed4fdc086ffff99386cb0f0027fbf5b17666666"),TD=mt("1b9e77d95f027570b3e7298a66a61ee6ab02a6761d666666"),AD=mt("4269d0efb118ff725c6cc5b03ca951ff8ab7a463f297bbf59c6b4e9498a0"),RD=mt("a6cee31f78b4b2df8a33a02cfb9a99e31a1cfdbf6fff7f00cab2d66a3d9affff99b15928"),CD=mt("fbb4aeb3cde3ccebc5decbe4fed9a6ffffcce5d8bdfddaecf2f2f2"),PD=mt("b3e2cdfdcdaccbd5e8f4cae4e6f5c9fff2aef1e2cccccccc"),ID=mt("e41a1c377eb84daf4a984ea3ff7f00ffff33a65628f781bf999999"),LD=mt("66c2a5fc8d628da0cbe78ac3a6d854ffd92fe5c494b3b3b3"),DD=mt("8dd3c7ffffb3bebadafb807280b1d3fdb462b3de69fccde5d9d9d9bc80bdccebc5ffed6f"),Gv=mt("4e79a7f28e2ce1575976b7b259a14fedc949af7aa1ff9da79c755fbab0ab"),jt=n=>Ov(n[n.length-1]),lS=new Array(3).concat("d8b365f5f5f55ab4ac","a6611adfc27d80cdc1018571","a6611adfc27df5f5f580cdc1018571","8c510ad8b365f6e8c3c7eae55ab4ac01665e","8c510ad8b365f6e8c3f5f5f5c7eae55ab4ac01665e","8c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e","8c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e","5430058c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e003c30","5430058c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e003c30").map(mt),ND=jt(lS),cS=new Array(3).concat("af8dc3f7f7f77fbf7b","7b3294c2a5cfa6dba0008837","7b3294c2a5cff7f7f7a6dba0008837","762a83af8dc3e7d4e8d9f0d37fbf7b1b7837","762a83af8dc3e7d4e8f7f7f7d9f0d37fbf7b1b7837","762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b7837","762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b7837","40004b762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b783700441b","40004b762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b783700441b").map(mt),UD=jt(cS),hS=new Array(3).concat("e9a3c9f7f7f7a1d76a","d01c8bf1b6dab8e1864dac26","d01c8bf1b6daf7f7f7b8e1864dac26","c51b7de9a3c9fde0efe6f5d0a1d76a4d9221","c51b7de9a3c9fde0eff7f7f7e6f5d0a1d76a4d9221","c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221","c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221","8e0152c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221276419","8e0152c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221276419").map(mt),FD=jt(hS),uS=new Array(3).concat("998ec3f7f7f7f1a340","5e3c99b2abd2fdb863e66101","5e3c99b2abd2f7f7f7fdb863e66101","542788998ec3d8daebfee0b6f1a340b35806","542788998ec3d8daebf7f7f7fee0b6f1a340b35806","5427888073acb2abd2d8daebfee0b6fdb863e08214b35806","5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b35806","2d004b5427888073acb2abd2d8daebfee0b6fdb863e08214b358067f3b08","2d004b5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b358067f3b08").map(mt),OD=jt(uS),fS=new Array(3).concat("ef8a62f7f7f767a9cf","ca0020f4a58292c5de0571b0","ca0020f4a582f7f7f792c5de0571b0","b2182bef8a62fddbc7d1e5f067a9cf2166ac","b2182bef8a62fddbc7f7f7f7d1e5f067a9cf2166ac","b2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac","b2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac","67001fb2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac053061","67001fb2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac053061").map(mt),Wv=jt(fS),dS=new Array(3).concat("ef8a62ffffff999999","ca0020f4a582bababa404040","ca0020f4a582ffffffbababa404040","b2182bef8a62fddbc7e0e0e09999994d4d4d","b2182bef8a62fddbc7ffffffe0e0e09999994d4d4d","b2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d","b2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d","67001fb2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d1a1a1a","67001fb2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d1a1a1a").map(mt),kD=jt(dS),pS=new Array(3).concat("fc8d59ffffbf91bfdb","d7191cfdae61abd9e92c7bb6","d7191cfdae61ffffbfabd9e92c7bb6","d73027fc8d59fee090e0f3f891bfdb4575b4","d73027fc8d59fee090ffffbfe0f3f891bfdb4575b4","d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4","d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4","a50026d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4313695","a50026d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4313695").map(mt),BD=jt(pS),mS=new Array(3).concat("fc8d59ffffbf91cf60","d7191cfdae61a6d96a1a9641","d7191cfdae61ffffbfa6d96a1a9641","d73027fc8d59fee08bd9ef8b91cf601a9850","d73027fc8d59fee08bffffbfd9ef8b91cf601a9850","d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850","d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850","a50026d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850006837","a50026d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850006837").map(mt),zD=jt(mS),gS=new Array(3).concat("fc8d59ffffbf99d594","d7191cfdae61abdda42b83ba","d7191cfdae61ffffbfabdda42b83ba","d53e4ffc8d59fee08be6f59899d5943288bd","d53e4ffc8d59fee08bffffbfe6f59899d5943288bd","d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd","d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd","9e0142d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd5e4fa2","9e0142d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd5e4fa2").map(mt),HD=jt(gS),vS=new Array(3).concat("e5f5f999d8c92ca25f","edf8fbb2e2e266c2a4238b45","edf8fbb2e2e266c2a42ca25f006d2c","edf8fbccece699d8c966c2a42ca25f006d2c","edf8fbccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45006d2c00441b").map(mt),VD=jt(vS),yS=new Array(3).concat("e0ecf49ebcda8856a7","edf8fbb3cde38c96c688419d","edf8fbb3cde38c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d810f7c4d004b").map(mt),GD=jt(yS),bS=new Array(3).concat("e0f3dba8ddb543a2ca","f0f9e8bae4bc7bccc42b8cbe","f0f9e8bae4bc7bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe0868ac084081").map(mt),WD=jt(bS),xS=new Array(3).concat("fee8c8fdbb84e34a33","fef0d9fdcc8afc8d59d7301f","fef0d9fdcc8afc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301fb300007f0000").map(mt),XD=jt(xS),_S=new Array(3).concat("ece2f0a6bddb1c9099","f6eff7bdc9e167a9cf02818a","f6eff7bdc9e167a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016c59014636").map(mt),$D=jt(_S),wS=new Array(3).concat("ece7f2a6bddb2b8cbe","f1eef6bdc9e174a9cf0570b0","f1eef6bdc9e174a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0045a8d023858").map(mt),qD=jt(wS),SS=new Array(3).concat("e7e1efc994c7dd1c77","f1eef6d7b5d8df65b0ce1256","f1eef6d7b5d8df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125698004367001f").map(mt),YD=jt(SS),MS=new Array(3).concat("fde0ddfa9fb5c51b8a","feebe2fbb4b9f768a1ae017e","feebe2fbb4b9f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a017749006a").map(mt),jD=jt(MS),ES=new Array(3).concat("edf8b17fcdbb2c7fb8","ffffcca1dab441b6c4225ea8","ffffcca1dab441b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea8253494081d58").map(mt),Sp=jt(ES),TS=new Array(3).concat("f7fcb9addd8e31a354","ffffccc2e69978c679238443","ffffccc2e69978c67931a354006837","ffffccd9f0a3addd8e78c67931a354006837","ffffccd9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443006837004529").map(mt),ZD=jt(TS),AS=new Array(3).concat("fff7bcfec44fd95f0e","ffffd4fed98efe9929cc4c02","ffffd4fed98efe9929d95f0e993404","ffffd4fee391fec44ffe9929d95f0e993404","ffffd4fee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c02993404662506").map(mt),JD=jt(AS),RS=new Array(3).concat("ffeda0feb24cf03b20","ffffb2fecc5cfd8d3ce31a1c","ffffb2fecc5cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cbd0026800026").map(mt),KD=jt(RS),CS=new Array(3).concat("deebf79ecae13182bd","eff3ffbdd7e76baed62171b5","eff3ffbdd7e76baed63182bd08519c","eff3ffc6dbef9ecae16baed63182bd08519c","eff3ffc6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b508519c08306b").map(mt),QD=jt(CS),PS=new Array(3).concat("e5f5e0a1d99b31a354","edf8e9bae4b374c476238b45","edf8e9bae4b374c47631a354006d2c","edf8e9c7e9c0a1d99b74c47631a354006d2c","edf8e9c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45006d2c00441b").map(mt),eN=jt(PS),IS=new Array(3).concat("f0f0f0bdbdbd636363","f7f7f7cccccc969696525252","f7f7f7cccccc969696636363252525","f7f7f7d9d9d9bdbdbd969696636363252525","f7f7f7d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525000000").map(mt),tN=jt(IS),LS=new Array(3).concat("efedf5bcbddc756bb1","f2f0f7cbc9e29e9ac86a51a3","f2f0f7cbc9e29e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a354278f3f007d").map(mt),nN=jt(LS),DS=new Array(3).concat("fee0d2fc9272de2d26","fee5d9fcae91fb6a4acb181d","fee5d9fcae91fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181da50f1567000d").map(mt),iN=jt(DS),NS=new Array(3).concat("fee6cefdae6be6550d","feeddefdbe85fd8d3cd94701","feeddefdbe85fd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d94801a636037f2704").map(mt),sN=jt(NS);function Xv(n){return n=Math.max(0,Math.min(1,n)),"rgb("+Math.max(0,Math.min(255,Math.round(-4.54-n*(35.34-n*(2381.73-n*(6402.7-n*(7024.72-n*2710.57)))))))+", "+Math.max(0,Math.min(255,Math.round(32.49+n*(170.73+n*(52.82-n*(131.46-n*(176.58-n*67.37)))))))+", "+Math.max(0,Math.min(255,Math.round(81.24+n*(442.36-n*(2482.43-n*(6167.24-n*(6614.94-n*2475.67)))))))+")"}var rN=ph(as(300,.5,0),as(-240,.5,1)),aN=ph(as(-100,.75,.35),as(80,1.5,.8)),oN=ph(as(260,.75,.35),as(80,1.5,.8)),lN=as();var cN=ga(),hN=Math.PI/3,uN=Math.PI*2/3;function $v(n){return n=Math.max(0,Math.min(1,n)),"rgb("+Math.max(0,Math.min(255,Math.round(34.61+n*(1172.33-n*(10793.56-n*(33300.12-n*(38394.49-n*14825.05)))))))+", "+Math.max(0,Math.min(255,Math.round(23.31+n*(557.33+n*(1225.33-n*(3574.96-n*(1073.77+n*707.56)))))))+", "+Math.max(0,Math.min(255,Math.round(27.2+n*(3211.1-n*(15327.97-n*(27814-n*(22569.18-n*6838.66)))))))+")"}function mh(n){var e=n.length;return function(t){return n[Math.max(0,Math.min(e-1,Math.floor(t*e)))]}}var qv=mh(mt("44015444025645045745055946075a46085c460a5d460b5e470d60470e6147106347116447136548146748166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde725")),Yv=mh(mt("00000401000501010601010802010902020b02020d03030f03031204041405041606051806051a07061c08071e0907200a08220b09240c09260d0a290e0b2b100b2d110c2f120d31130d34140e36150e38160f3b180f3d19103f1a10421c10441d11471e114920114b21114e22115024125325125527125829115a2a115c2c115f2d11612f116331116533106734106936106b38106c390f6e3b0f703d0f713f0f72400f74420f75440f764510774710784910784a10794c117a4e117b4f127b51127c52137c54137d56147d57157e59157e5a167e5c167f5d177f5f187f601880621980641a80651a80671b80681c816a1c816b1d816d1d816e1e81701f81721f817320817521817621817822817922827b23827c23827e24828025828125818326818426818627818827818928818b29818c29818e2a81902a81912b81932b80942c80962c80982d80992d809b2e7f9c2e7f9e2f7fa02f7fa1307ea3307ea5317ea6317da8327daa337dab337cad347cae347bb0357bb2357bb3367ab5367ab73779b83779ba3878bc3978bd3977bf3a77c03a76c23b75c43c75c53c74c73d73c83e73ca3e72cc3f71cd4071cf4070d0416fd2426fd3436ed5446dd6456cd8456cd9466bdb476adc4869de4968df4a68e04c67e24d66e34e65e44f64e55064e75263e85362e95462ea5661eb5760ec5860ed5a5fee5b5eef5d5ef05f5ef1605df2625df2645cf3655cf4675cf4695cf56b5cf66c5cf66e5cf7705cf7725cf8745cf8765cf9785df9795df97b5dfa7d5efa7f5efa815ffb835ffb8560fb8761fc8961fc8a62fc8c63fc8e64fc9065fd9266fd9467fd9668fd9869fd9a6afd9b6bfe9d6cfe9f6dfea16efea36ffea571fea772fea973feaa74feac76feae77feb078feb27afeb47bfeb67cfeb77efeb97ffebb81febd82febf84fec185fec287fec488fec68afec88cfeca8dfecc8ffecd90fecf92fed194fed395fed597fed799fed89afdda9cfddc9efddea0fde0a1fde2a3fde3a5fde5a7fde7a9fde9aafdebacfcecaefceeb0fcf0b2fcf2b4fcf4b6fcf6b8fcf7b9fcf9bbfcfbbdfcfdbf")),fN=mh(mt("00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c431e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f3609613809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f24699025689225689326679526679727669827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305cb0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4ec63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3ed94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602de9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1fcffa4")),dN=mh(mt("0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e05952f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a66100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a87801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba58e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9ba21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8eb42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72d24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844bf3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983ef99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724f0f921"));/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var cs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Es={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},By=0,om=1,zy=2;var vc=1,Hy=2,Uo=3,$s=0,Pi=1,vn=2,Mr=0,Fo=1,lm=2,cm=3,hm=4,Vy=5;var Sa=100,Gy=101,Wy=102,Xy=103,$y=104,qy=200,Yy=201,jy=202,Zy=203,um=204,fm=205,Jy=206,Ky=207,Qy=208,eb=209,tb=210,nb=211,ib=212,sb=213,rb=214,$h=0,qh=1,Yh=2,wo=3,jh=4,Zh=5,Jh=6,Kh=7,Pu=0,ab=1,ob=2,qs=0,dm=1,pm=2,mm=3,gm=4,vm=5,ym=6,bm=7;var xm=300,Ma=301,Oo=302,Iu=303,Lu=304,Qh=1e3,Hs=1001,eu=1002,en=1003,lb=1004;var yc=1005;var Ri=1006,Du=1007;var Er=1008;var Oi=1009,_m=1010,wm=1011,ko=1012,Nu=1013,Ji=1014,hs=1015,Ts=1016,Uu=1017,Fu=1018,Ea=1020,Sm=35902,Mm=35899,Em=1021,Tm=1022,As=1023,vr=1026,Tr=1027,Ou=1028,ku=1029,ia=1030,Bu=1031;var zu=1033,bc=33776,xc=33777,_c=33778,wc=33779,Hu=35840,Vu=35841,Gu=35842,Wu=35843,Xu=36196,$u=37492,qu=37496,Yu=37488,ju=37489,Sc=37490,Zu=37491,Ju=37808,Ku=37809,Qu=37810,ef=37811,tf=37812,nf=37813,sf=37814,rf=37815,af=37816,of=37817,lf=37818,cf=37819,hf=37820,uf=37821,ff=36492,df=36494,pf=36495,mf=36283,gf=36284,Mc=36285,vf=36286;var Fl=2300,tu=2301,Wh=2302,jp=2303,Zp=2400,Jp=2401,Kp=2402;var cb=3200;var yf=0,hb=1,Ar="",Ti="srgb",Ol="srgb-linear",kl="linear",kt="srgb";var Xh=7680;var ub=519,fb=512,db=513,pb=514,Am=515,mb=516,gb=517,Rm=518,Cm=519,Pm=35044,Ec=35048;var Im="300 es",ls=2e3,So=2001;function US(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function FS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Bl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function vb(){let n=Bl("canvas");return n.style.display="block",n}var jv={},Mo=null;function zl(...n){let e="THREE."+n.shift();Mo?Mo("log",e,...n):console.log(e,...n)}function yb(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Je(...n){n=yb(n);let e="THREE."+n.shift();if(Mo)Mo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function rt(...n){n=yb(n);let e="THREE."+n.shift();if(Mo)Mo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Il(...n){let e=n.join(" ");e in jv||(jv[e]=!0,Je(...n))}function bb(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var xb={[$h]:$h,[Yh]:Jh,[jh]:jh,[wo]:Zh,[qh]:qh,[Jh]:Yh,[Kh]:Kh,[Zh]:wo},_s=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},mi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Zv=1234567,Ll=Math.PI/180,Eo=180/Math.PI;function Rr(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(mi[n&255]+mi[n>>8&255]+mi[n>>16&255]+mi[n>>24&255]+"-"+mi[e&255]+mi[e>>8&255]+"-"+mi[e>>16&15|64]+mi[e>>24&255]+"-"+mi[t&63|128]+mi[t>>8&255]+"-"+mi[t>>16&255]+mi[t>>24&255]+mi[i&255]+mi[i>>8&255]+mi[i>>16&255]+mi[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function Lm(n,e){return(n%e+e)%e}function OS(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function kS(n,e,t){return n!==e?(t-n)/(e-n):0}function Dl(n,e,t){return(1-t)*n+t*e}function BS(n,e,t,i){return Dl(n,e,1-Math.exp(-t*i))}function zS(n,e=1){return e-Math.abs(Lm(n,e*2)-e)}function HS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function VS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function GS(n,e){return n+Math.floor(Math.random()*(e-n+1))}function WS(n,e){return n+Math.random()*(e-n)}function XS(n){return n*(.5-Math.random())}function $S(n){n!==void 0&&(Zv=n);let e=Zv+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function qS(n){return n*Ll}function YS(n){return n*Eo}function jS(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function ZS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Dm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function JS(n,e,t,i,s){let r=Math.cos,a=Math.sin,o=r(t/2),l=a(t/2),c=r((e+i)/2),h=a((e+i)/2),u=r((e-i)/2),f=a((e-i)/2),d=r((i-e)/2),p=a((i-e)/2);switch(s){case"XYX":n.set(o*h,l*u,l*f,o*c);break;case"YZY":n.set(l*f,o*h,l*u,o*c);break;case"ZXZ":n.set(l*u,l*f,o*h,o*c);break;case"XZX":n.set(o*h,l*p,l*d,o*c);break;case"YXY":n.set(l*d,o*h,l*p,o*c);break;case"ZYZ":n.set(l*p,l*d,o*h,o*c);break;default:Je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function bf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Nm(n,e){if(e.constructor===Float32Array)return n;let t=bf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Um(n,e){if(e.constructor===Float32Array)return n;let t=bf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Kn={DEG2RAD:Ll,RAD2DEG:Eo,generateUUID:Rr,clamp:ct,euclideanModulo:Lm,mapLinear:OS,inverseLerp:kS,lerp:Dl,damp:BS,pingpong:zS,smoothstep:HS,smootherstep:VS,randInt:GS,randFloat:WS,randFloatSpread:XS,seededRandom:$S,degToRad:qS,radToDeg:YS,isPowerOfTwo:jS,ceilPowerOfTwo:ZS,floorPowerOfTwo:Dm,setQuaternionFromProperEuler:JS,normalize:Um,denormalize:Nm},Se=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*i-a*s+e.x,this.y=r*s+a*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ci=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,a,o){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],f=r[a+0],d=r[a+1],p=r[a+2],v=r[a+3];if(u!==v||l!==f||c!==d||h!==p){let m=l*f+c*d+h*p+u*v;m<0&&(f=-f,d=-d,p=-p,v=-v,m=-m);let g=1-o;if(m<.9995){let y=Math.acos(m),_=Math.sin(y);g=Math.sin(g*y)/_,o=Math.sin(o*y)/_,l=l*g+f*o,c=c*g+d*o,h=h*g+p*o,u=u*g+v*o}else{l=l*g+f*o,c=c*g+d*o,h=h*g+p*o,u=u*g+v*o;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,i,s,r,a){let o=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[a],f=r[a+1],d=r[a+2],p=r[a+3];return e[t]=o*p+h*u+l*d-c*f,e[t+1]=l*p+h*f+c*u-o*d,e[t+2]=c*p+h*d+o*f-l*u,e[t+3]=h*p-o*u-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(i/2),h=o(s/2),u=o(r/2),f=l(i/2),d=l(s/2),p=l(r/2);switch(a){case"XYZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"YXZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"ZXY":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"ZYX":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"YZX":this._x=f*h*u+c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u-f*d*p;break;case"XZY":this._x=f*h*u-c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u+f*d*p;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],u=t[10],f=i+o+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(a-s)*d}else if(i>o&&i>u){let d=2*Math.sqrt(1+i-o-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+a)/d,this._z=(r+c)/d}else if(o>u){let d=2*Math.sqrt(1+o-i-u);this._w=(r-c)/d,this._x=(s+a)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-i-o);this._w=(a-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-i*c,this._z=r*h+a*c+i*l-s*o,this._w=a*h-i*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(i=-i,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},P=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Jv.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Jv.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*i),h=2*(o*t-r*s),u=2*(r*i-a*t);return this.x=t+l*c+a*u-o*h,this.y=i+l*h+o*c-r*u,this.z=s+l*u+r*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-i*l,this.z=i*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Mp.copy(this).projectOnVector(e),this.sub(Mp)}reflect(e){return this.sub(Mp.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Mp=new P,Jv=new Ci,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c)}set(e,t,i,s,r,a,o,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=o,h[3]=t,h[4]=r,h[5]=l,h[6]=i,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[3],l=i[6],c=i[1],h=i[4],u=i[7],f=i[2],d=i[5],p=i[8],v=s[0],m=s[3],g=s[6],y=s[1],_=s[4],x=s[7],T=s[2],M=s[5],b=s[8];return r[0]=a*v+o*y+l*T,r[3]=a*m+o*_+l*M,r[6]=a*g+o*x+l*b,r[1]=c*v+h*y+u*T,r[4]=c*m+h*_+u*M,r[7]=c*g+h*x+u*b,r[2]=f*v+d*y+p*T,r[5]=f*m+d*_+p*M,r[8]=f*g+d*x+p*b,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-i*r*h+i*o*l+s*r*c-s*a*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],u=h*a-o*c,f=o*l-h*r,d=c*r-a*l,p=t*u+i*f+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=u*v,e[1]=(s*c-h*i)*v,e[2]=(o*i-s*a)*v,e[3]=f*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-o*t)*v,e[6]=d*v,e[7]=(i*l-c*t)*v,e[8]=(a*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return Il("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ep.makeScale(e,t)),this}rotate(e){return Il("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ep.makeRotation(-e)),this}translate(e,t){return Il("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ep.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ep=new nt,Kv=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Qv=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function KS(){let n={enabled:!0,workingColorSpace:Ol,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===kt&&(s.r=gr(s.r),s.g=gr(s.g),s.b=gr(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===kt&&(s.r=_o(s.r),s.g=_o(s.g),s.b=_o(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ar?kl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ol]:{primaries:e,whitePoint:i,transfer:kl,toXYZ:Kv,fromXYZ:Qv,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Ti},outputColorSpaceConfig:{drawingBufferColorSpace:Ti}},[Ti]:{primaries:e,whitePoint:i,transfer:kt,toXYZ:Kv,fromXYZ:Qv,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Ti}}}),n}var Et=KS();function gr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function _o(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var so,nu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{so===void 0&&(so=Bl("canvas")),so.width=e.width,so.height=e.height;let s=so.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=so}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Bl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=gr(r[a]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(gr(t[i]/255)*255):t[i]=gr(t[i]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},QS=0,To=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:QS++}),this.uuid=Rr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(Tp(s[a].image)):r.push(Tp(s[a]))}else r=Tp(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Tp(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?nu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var eM=0,Ap=new P,Ni=class n extends _s{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Hs,s=Hs,r=Ri,a=Er,o=As,l=Oi,c=n.DEFAULT_ANISOTROPY,h=Ar){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:eM++}),this.uuid=Rr(),this.name="",this.source=new To(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Se(0,0),this.repeat=new Se(1,1),this.center=new Se(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ap).x}get height(){return this.source.getSize(Ap).y}get depth(){return this.source.getSize(Ap).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==xm)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Qh:e.x=e.x-Math.floor(e.x);break;case Hs:e.x=e.x<0?0:1;break;case eu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Qh:e.y=e.y-Math.floor(e.y);break;case Hs:e.y=e.y<0?0:1;break;case eu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Ni.DEFAULT_IMAGE=null;Ni.DEFAULT_MAPPING=xm;Ni.DEFAULT_ANISOTROPY=1;var Bt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*i+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*i+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*i+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*i+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],p=l[9],v=l[2],m=l[6],g=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-v)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+v)<.1&&Math.abs(p+m)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let _=(c+1)/2,x=(d+1)/2,T=(g+1)/2,M=(h+f)/4,b=(u+v)/4,S=(p+m)/4;return _>x&&_>T?_<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(_),s=M/i,r=b/i):x>T?x<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),i=M/s,r=S/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=b/r,s=S/r),this.set(i,s,r,t),this}let y=Math.sqrt((m-p)*(m-p)+(u-v)*(u-v)+(f-h)*(f-h));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(u-v)/y,this.z=(f-h)/y,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},iu=class extends _s{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ri,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Bt(0,0,e,t),this.scissorTest=!1,this.viewport=new Bt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ni({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Ri,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new To(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ai=class extends iu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Hl=class extends Ni{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=en,this.minFilter=en,this.wrapR=Hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var su=class extends Ni{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=en,this.minFilter=en,this.wrapR=Hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var St=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,a,o,l,c,h,u,f,d,p,v,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c,h,u,f,d,p,v,m)}set(e,t,i,s,r,a,o,l,c,h,u,f,d,p,v,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=a,g[9]=o,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=f,g[3]=d,g[7]=p,g[11]=v,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/ro.setFromMatrixColumn(e,0).length(),r=1/ro.setFromMatrixColumn(e,1).length(),a=1/ro.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*a,t[9]=i[9]*a,t[10]=i[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,a=Math.cos(i),o=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let f=a*h,d=a*u,p=o*h,v=o*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=d+p*c,t[5]=f-v*c,t[9]=-o*l,t[2]=v-f*c,t[6]=p+d*c,t[10]=a*l}else if(e.order==="YXZ"){let f=l*h,d=l*u,p=c*h,v=c*u;t[0]=f+v*o,t[4]=p*o-d,t[8]=a*c,t[1]=a*u,t[5]=a*h,t[9]=-o,t[2]=d*o-p,t[6]=v+f*o,t[10]=a*l}else if(e.order==="ZXY"){let f=l*h,d=l*u,p=c*h,v=c*u;t[0]=f-v*o,t[4]=-a*u,t[8]=p+d*o,t[1]=d+p*o,t[5]=a*h,t[9]=v-f*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let f=a*h,d=a*u,p=o*h,v=o*u;t[0]=l*h,t[4]=p*c-d,t[8]=f*c+v,t[1]=l*u,t[5]=v*c+f,t[9]=d*c-p,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let f=a*l,d=a*c,p=o*l,v=o*c;t[0]=l*h,t[4]=v-f*u,t[8]=p*u+d,t[1]=u,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=d*u+p,t[10]=f-v*u}else if(e.order==="XZY"){let f=a*l,d=a*c,p=o*l,v=o*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=f*u+v,t[5]=a*h,t[9]=d*u-p,t[2]=p*u-d,t[6]=o*h,t[10]=v*u+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(tM,e,nM)}lookAt(e,t,i){let s=this.elements;return $i.subVectors(e,t),$i.lengthSq()===0&&($i.z=1),$i.normalize(),Xr.crossVectors(i,$i),Xr.lengthSq()===0&&(Math.abs(i.z)===1?$i.x+=1e-4:$i.z+=1e-4,$i.normalize(),Xr.crossVectors(i,$i)),Xr.normalize(),gh.crossVectors($i,Xr),s[0]=Xr.x,s[4]=gh.x,s[8]=$i.x,s[1]=Xr.y,s[5]=gh.y,s[9]=$i.y,s[2]=Xr.z,s[6]=gh.z,s[10]=$i.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[4],l=i[8],c=i[12],h=i[1],u=i[5],f=i[9],d=i[13],p=i[2],v=i[6],m=i[10],g=i[14],y=i[3],_=i[7],x=i[11],T=i[15],M=s[0],b=s[4],S=s[8],C=s[12],I=s[1],L=s[5],O=s[9],z=s[13],U=s[2],G=s[6],q=s[10],H=s[14],le=s[3],j=s[7],te=s[11],ne=s[15];return r[0]=a*M+o*I+l*U+c*le,r[4]=a*b+o*L+l*G+c*j,r[8]=a*S+o*O+l*q+c*te,r[12]=a*C+o*z+l*H+c*ne,r[1]=h*M+u*I+f*U+d*le,r[5]=h*b+u*L+f*G+d*j,r[9]=h*S+u*O+f*q+d*te,r[13]=h*C+u*z+f*H+d*ne,r[2]=p*M+v*I+m*U+g*le,r[6]=p*b+v*L+m*G+g*j,r[10]=p*S+v*O+m*q+g*te,r[14]=p*C+v*z+m*H+g*ne,r[3]=y*M+_*I+x*U+T*le,r[7]=y*b+_*L+x*G+T*j,r[11]=y*S+_*O+x*q+T*te,r[15]=y*C+_*z+x*H+T*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],u=e[6],f=e[10],d=e[14],p=e[3],v=e[7],m=e[11],g=e[15],y=l*d-c*f,_=o*d-c*u,x=o*f-l*u,T=a*d-c*h,M=a*f-l*h,b=a*u-o*h;return t*(v*y-m*_+g*x)-i*(p*y-m*T+g*M)+s*(p*_-v*T+g*b)-r*(p*x-v*M+m*b)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],h=e[10];return t*(a*h-o*c)-i*(r*h-o*l)+s*(r*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],u=e[9],f=e[10],d=e[11],p=e[12],v=e[13],m=e[14],g=e[15],y=t*o-i*a,_=t*l-s*a,x=t*c-r*a,T=i*l-s*o,M=i*c-r*o,b=s*c-r*l,S=h*v-u*p,C=h*m-f*p,I=h*g-d*p,L=u*m-f*v,O=u*g-d*v,z=f*g-d*m,U=y*z-_*O+x*L+T*I-M*C+b*S;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/U;return e[0]=(o*z-l*O+c*L)*G,e[1]=(s*O-i*z-r*L)*G,e[2]=(v*b-m*M+g*T)*G,e[3]=(f*M-u*b-d*T)*G,e[4]=(l*I-a*z-c*C)*G,e[5]=(t*z-s*I+r*C)*G,e[6]=(m*x-p*b-g*_)*G,e[7]=(h*b-f*x+d*_)*G,e[8]=(a*O-o*I+c*S)*G,e[9]=(i*I-t*O-r*S)*G,e[10]=(p*M-v*x+g*y)*G,e[11]=(u*x-h*M-d*y)*G,e[12]=(o*C-a*L-l*S)*G,e[13]=(t*L-i*C+s*S)*G,e[14]=(v*_-p*T-m*y)*G,e[15]=(h*T-u*_+f*y)*G,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,a=e.x,o=e.y,l=e.z,c=r*a,h=r*o;return this.set(c*a+i,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+i,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,a){return this.set(1,i,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,h=a+a,u=o+o,f=r*c,d=r*h,p=r*u,v=a*h,m=a*u,g=o*u,y=l*c,_=l*h,x=l*u,T=i.x,M=i.y,b=i.z;return s[0]=(1-(v+g))*T,s[1]=(d+x)*T,s[2]=(p-_)*T,s[3]=0,s[4]=(d-x)*M,s[5]=(1-(f+g))*M,s[6]=(m+y)*M,s[7]=0,s[8]=(p+_)*b,s[9]=(m-y)*b,s[10]=(1-(f+v))*b,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let a=ro.set(s[0],s[1],s[2]).length(),o=ro.set(s[4],s[5],s[6]).length(),l=ro.set(s[8],s[9],s[10]).length();r<0&&(a=-a),ys.copy(this);let c=1/a,h=1/o,u=1/l;return ys.elements[0]*=c,ys.elements[1]*=c,ys.elements[2]*=c,ys.elements[4]*=h,ys.elements[5]*=h,ys.elements[6]*=h,ys.elements[8]*=u,ys.elements[9]*=u,ys.elements[10]*=u,t.setFromRotationMatrix(ys),i.x=a,i.y=o,i.z=l,this}makePerspective(e,t,i,s,r,a,o=ls,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(i-s),f=(t+e)/(t-e),d=(i+s)/(i-s),p,v;if(l)p=r/(a-r),v=a*r/(a-r);else if(o===ls)p=-(a+r)/(a-r),v=-2*a*r/(a-r);else if(o===So)p=-a/(a-r),v=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,a,o=ls,l=!1){let c=this.elements,h=2/(t-e),u=2/(i-s),f=-(t+e)/(t-e),d=-(i+s)/(i-s),p,v;if(l)p=1/(a-r),v=a/(a-r);else if(o===ls)p=-2/(a-r),v=-(a+r)/(a-r);else if(o===So)p=-1/(a-r),v=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},ro=new P,ys=new St,tM=new P(0,0,0),nM=new P(1,1,1),Xr=new P,gh=new P,$i=new P,ey=new St,ty=new Ci,yr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ct(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ct(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(o,d));break;case"XZY":this._z=Math.asin(-ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return ey.makeRotationFromQuaternion(e),this.setFromRotationMatrix(ey,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ty.setFromEuler(this),this.setFromQuaternion(ty,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};yr.DEFAULT_ORDER="XYZ";var Ao=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},iM=0,ny=new P,ao=new Ci,ur=new St,vh=new P,Sl=new P,sM=new P,rM=new Ci,iy=new P(1,0,0),sy=new P(0,1,0),ry=new P(0,0,1),ay={type:"added"},aM={type:"removed"},oo={type:"childadded",child:null},Rp={type:"childremoved",child:null},dn=class n extends _s{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:iM++}),this.uuid=Rr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new P,t=new yr,i=new Ci,s=new P(1,1,1);function r(){i.setFromEuler(t,!1)}function a(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new St},normalMatrix:{value:new nt}}),this.matrix=new St,this.matrixWorld=new St,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ao,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.multiply(ao),this}rotateOnWorldAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.premultiply(ao),this}rotateX(e){return this.rotateOnAxis(iy,e)}rotateY(e){return this.rotateOnAxis(sy,e)}rotateZ(e){return this.rotateOnAxis(ry,e)}translateOnAxis(e,t){return ny.copy(e).applyQuaternion(this.quaternion),this.position.add(ny.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(iy,e)}translateY(e){return this.translateOnAxis(sy,e)}translateZ(e){return this.translateOnAxis(ry,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ur.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?vh.copy(e):vh.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Sl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ur.lookAt(Sl,vh,this.up):ur.lookAt(vh,Sl,this.up),this.quaternion.setFromRotationMatrix(ur),s&&(ur.extractRotation(s.matrixWorld),ao.setFromRotationMatrix(ur),this.quaternion.premultiply(ao.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(rt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ay),oo.child=e,this.dispatchEvent(oo),oo.child=null):rt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(aM),Rp.child=e,this.dispatchEvent(Rp),Rp.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ur.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ur.multiply(e.parent.matrixWorld)),e.applyMatrix4(ur),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ay),oo.child=e,this.dispatchEvent(oo),oo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let a=this.children[i].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Sl,e,sM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Sl,rM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),u=a(e.shapes),f=a(e.skeletons),d=a(e.animations),p=a(e.nodes);o.length>0&&(i.geometries=o),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};dn.DEFAULT_UP=new P(0,1,0);dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Zt=class extends dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},oM={type:"move"},Ro=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Zt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Zt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new P,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new P),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Zt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new P,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new P,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let v of e.hand.values()){let m=t.getJointPose(v,i),g=this._getHandJoint(c,v);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,p=.005;c.inputState.pinching&&f>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(oM)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Zt;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},_b={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},$r={h:0,s:0,l:0},yh={h:0,s:0,l:0};function Cp(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var qe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Ti){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Et.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Et.workingColorSpace){return this.r=e,this.g=t,this.b=i,Et.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Et.workingColorSpace){if(e=Lm(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,a=2*i-r;this.r=Cp(a,r,e+1/3),this.g=Cp(a,r,e),this.b=Cp(a,r,e-1/3)}return Et.colorSpaceToWorking(this,s),this}setStyle(e,t=Ti){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Ti){let i=_b[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=gr(e.r),this.g=gr(e.g),this.b=gr(e.b),this}copyLinearToSRGB(e){return this.r=_o(e.r),this.g=_o(e.g),this.b=_o(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Ti){return Et.workingToColorSpace(gi.copy(this),e),Math.round(ct(gi.r*255,0,255))*65536+Math.round(ct(gi.g*255,0,255))*256+Math.round(ct(gi.b*255,0,255))}getHexString(e=Ti){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Et.workingColorSpace){Et.workingToColorSpace(gi.copy(this),t);let i=gi.r,s=gi.g,r=gi.b,a=Math.max(i,s,r),o=Math.min(i,s,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let u=a-o;switch(c=h<=.5?u/(a+o):u/(2-a-o),a){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Et.workingColorSpace){return Et.workingToColorSpace(gi.copy(this),t),e.r=gi.r,e.g=gi.g,e.b=gi.b,e}getStyle(e=Ti){Et.workingToColorSpace(gi.copy(this),e);let t=gi.r,i=gi.g,s=gi.b;return e!==Ti?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL($r),this.setHSL($r.h+e,$r.s+t,$r.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL($r),e.getHSL(yh);let i=Dl($r.h,yh.h,t),s=Dl($r.s,yh.s,t),r=Dl($r.l,yh.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},gi=new qe;qe.NAMES=_b;var Vl=class extends dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new yr,this.environmentIntensity=1,this.environmentRotation=new yr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},bs=new P,fr=new P,Pp=new P,dr=new P,lo=new P,co=new P,oy=new P,Ip=new P,Lp=new P,Dp=new P,Np=new Bt,Up=new Bt,Fp=new Bt,Zr=class n{constructor(e=new P,t=new P,i=new P){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),bs.subVectors(e,t),s.cross(bs);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){bs.subVectors(s,t),fr.subVectors(i,t),Pp.subVectors(e,t);let a=bs.dot(bs),o=bs.dot(fr),l=bs.dot(Pp),c=fr.dot(fr),h=fr.dot(Pp),u=a*c-o*o;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-o*h)*f,p=(a*h-o*l)*f;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,dr)===null?!1:dr.x>=0&&dr.y>=0&&dr.x+dr.y<=1}static getInterpolation(e,t,i,s,r,a,o,l){return this.getBarycoord(e,t,i,s,dr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,dr.x),l.addScaledVector(a,dr.y),l.addScaledVector(o,dr.z),l)}static getInterpolatedAttribute(e,t,i,s,r,a){return Np.setScalar(0),Up.setScalar(0),Fp.setScalar(0),Np.fromBufferAttribute(e,t),Up.fromBufferAttribute(e,i),Fp.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Np,r.x),a.addScaledVector(Up,r.y),a.addScaledVector(Fp,r.z),a}static isFrontFacing(e,t,i,s){return bs.subVectors(i,t),fr.subVectors(e,t),bs.cross(fr).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return bs.subVectors(this.c,this.b),fr.subVectors(this.a,this.b),bs.cross(fr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,a,o;lo.subVectors(s,i),co.subVectors(r,i),Ip.subVectors(e,i);let l=lo.dot(Ip),c=co.dot(Ip);if(l<=0&&c<=0)return t.copy(i);Lp.subVectors(e,s);let h=lo.dot(Lp),u=co.dot(Lp);if(h>=0&&u<=h)return t.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),t.copy(i).addScaledVector(lo,a);Dp.subVectors(e,r);let d=lo.dot(Dp),p=co.dot(Dp);if(p>=0&&d<=p)return t.copy(r);let v=d*c-l*p;if(v<=0&&c>=0&&p<=0)return o=c/(c-p),t.copy(i).addScaledVector(co,o);let m=h*p-d*u;if(m<=0&&u-h>=0&&d-p>=0)return oy.subVectors(r,s),o=(u-h)/(u-h+(d-p)),t.copy(s).addScaledVector(oy,o);let g=1/(m+v+f);return a=v*g,o=f*g,t.copy(i).addScaledVector(lo,a).addScaledVector(co,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},tn=class{constructor(e=new P(1/0,1/0,1/0),t=new P(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(xs.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(xs.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=xs.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,xs):xs.fromBufferAttribute(r,a),xs.applyMatrix4(e.matrixWorld),this.expandByPoint(xs);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),bh.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),bh.copy(i.boundingBox)),bh.applyMatrix4(e.matrixWorld),this.union(bh)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,xs),xs.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ml),xh.subVectors(this.max,Ml),ho.subVectors(e.a,Ml),uo.subVectors(e.b,Ml),fo.subVectors(e.c,Ml),qr.subVectors(uo,ho),Yr.subVectors(fo,uo),va.subVectors(ho,fo);let t=[0,-qr.z,qr.y,0,-Yr.z,Yr.y,0,-va.z,va.y,qr.z,0,-qr.x,Yr.z,0,-Yr.x,va.z,0,-va.x,-qr.y,qr.x,0,-Yr.y,Yr.x,0,-va.y,va.x,0];return!Op(t,ho,uo,fo,xh)||(t=[1,0,0,0,1,0,0,0,1],!Op(t,ho,uo,fo,xh))?!1:(_h.crossVectors(qr,Yr),t=[_h.x,_h.y,_h.z],Op(t,ho,uo,fo,xh))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,xs).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(xs).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(pr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),pr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),pr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),pr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),pr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),pr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),pr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),pr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(pr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},pr=[new P,new P,new P,new P,new P,new P,new P,new P],xs=new P,bh=new tn,ho=new P,uo=new P,fo=new P,qr=new P,Yr=new P,va=new P,Ml=new P,xh=new P,_h=new P,ya=new P;function Op(n,e,t,i,s){for(let r=0,a=n.length-3;r<=a;r+=3){ya.fromArray(n,r);let o=s.x*Math.abs(ya.x)+s.y*Math.abs(ya.y)+s.z*Math.abs(ya.z),l=e.dot(ya),c=t.dot(ya),h=i.dot(ya);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var Ln=new P,wh=new Se,lM=0,ln=class extends _s{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:lM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Pm,this.updateRanges=[],this.gpuType=hs,this.version=0,this._normalizationScale=e!==void 0?bf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)wh.fromBufferAttribute(this,t),wh.applyMatrix3(e),this.setXY(t,wh.x,wh.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Ln.fromBufferAttribute(this,t),Ln.applyMatrix3(e),this.setXYZ(t,Ln.x,Ln.y,Ln.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Ln.fromBufferAttribute(this,t),Ln.applyMatrix4(e),this.setXYZ(t,Ln.x,Ln.y,Ln.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Ln.fromBufferAttribute(this,t),Ln.applyNormalMatrix(e),this.setXYZ(t,Ln.x,Ln.y,Ln.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Ln.fromBufferAttribute(this,t),Ln.transformDirection(e),this.setXYZ(t,Ln.x,Ln.y,Ln.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Nm(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Um(e,this.array)}};var Gl=class extends ln{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Wl=class extends ln{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var tt=class extends ln{constructor(e,t,i){super(new Float32Array(e),t,i)}},cM=new tn,El=new P,kp=new P,vi=class{constructor(e=new P,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):cM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;El.subVectors(e,this.center);let t=El.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(El,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(kp.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(El.copy(e.center).add(kp)),this.expandByPoint(El.copy(e.center).sub(kp))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},hM=0,os=new St,Bp=new dn,po=new P,qi=new tn,Tl=new tn,Jn=new P,vt=class n extends _s{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:hM++}),this.uuid=Rr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(US(e)?Wl:Gl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new nt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return os.makeRotationFromQuaternion(e),this.applyMatrix4(os),this}rotateX(e){return os.makeRotationX(e),this.applyMatrix4(os),this}rotateY(e){return os.makeRotationY(e),this.applyMatrix4(os),this}rotateZ(e){return os.makeRotationZ(e),this.applyMatrix4(os),this}translate(e,t,i){return os.makeTranslation(e,t,i),this.applyMatrix4(os),this}scale(e,t,i){return os.makeScale(e,t,i),this.applyMatrix4(os),this}lookAt(e){return Bp.lookAt(e),Bp.updateMatrix(),this.applyMatrix4(Bp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(po).negate(),this.translate(po.x,po.y,po.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new tt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new P(-1/0,-1/0,-1/0),new P(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];qi.setFromBufferAttribute(r),this.morphTargetsRelative?(Jn.addVectors(this.boundingBox.min,qi.min),this.boundingBox.expandByPoint(Jn),Jn.addVectors(this.boundingBox.max,qi.max),this.boundingBox.expandByPoint(Jn)):(this.boundingBox.expandByPoint(qi.min),this.boundingBox.expandByPoint(qi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&rt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new vi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new P,1/0);return}if(e){let i=this.boundingSphere.center;if(qi.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];Tl.setFromBufferAttribute(o),this.morphTargetsRelative?(Jn.addVectors(qi.min,Tl.min),qi.expandByPoint(Jn),Jn.addVectors(qi.max,Tl.max),qi.expandByPoint(Jn)):(qi.expandByPoint(Tl.min),qi.expandByPoint(Tl.max))}qi.getCenter(i);let s=0;for(let r=0,a=e.count;r<a;r++)Jn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Jn));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)Jn.fromBufferAttribute(o,c),l&&(po.fromBufferAttribute(e,c),Jn.add(po)),s=Math.max(s,i.distanceToSquared(Jn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&rt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){rt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==i.count)&&(a=new ln(new Float32Array(4*i.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(i.count);for(let C=0;C<i.count;C++)o[C]=new P,l[C]=new P;let h=new P,u=new P,f=new P,d=new Se,p=new Se,v=new Se,m=new P,g=new P;function y(C,I,L){c[C]=c[I]=c[L]=1,h.fromBufferAttribute(i,C),u.fromBufferAttribute(i,I),f.fromBufferAttribute(i,L),d.fromBufferAttribute(r,C),p.fromBufferAttribute(r,I),v.fromBufferAttribute(r,L),u.sub(h),f.sub(h),p.sub(d),v.sub(d);let O=1/(p.x*v.y-v.x*p.y);isFinite(O)&&(m.copy(u).multiplyScalar(v.y).addScaledVector(f,-p.y).multiplyScalar(O),g.copy(f).multiplyScalar(p.x).addScaledVector(u,-v.x).multiplyScalar(O),o[C].add(m),o[I].add(m),o[L].add(m),l[C].add(g),l[I].add(g),l[L].add(g))}let _=this.groups;_.length===0&&(_=[{start:0,count:e.count}]);for(let C=0,I=_.length;C<I;++C){let L=_[C],O=L.start,z=L.count;for(let U=O,G=O+z;U<G;U+=3)y(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let x=new P,T=new P,M=new P,b=new P;function S(C){M.fromBufferAttribute(s,C),b.copy(M);let I=o[C];x.copy(I),x.sub(M.multiplyScalar(M.dot(I))).normalize(),T.crossVectors(b,I);let O=T.dot(l[C])<0?-1:1;a.setXYZW(C,x.x,x.y,x.z,O)}for(let C=0,I=i.count;C<I;++C)c[C]&&S(C);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new ln(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new P,r=new P,a=new P,o=new P,l=new P,c=new P,h=new P,u=new P;if(e)for(let f=0,d=e.count;f<d;f+=3){let p=e.getX(f+0),v=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),a.fromBufferAttribute(t,m),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),o.fromBufferAttribute(i,p),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),o.add(h),l.add(h),c.add(h),i.setXYZ(p,o.x,o.y,o.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),a.fromBufferAttribute(t,f+2),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),i.setXYZ(f+0,h.x,h.y,h.z),i.setXYZ(f+1,h.x,h.y,h.z),i.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Jn.fromBufferAttribute(e,t),Jn.normalize(),e.setXYZ(t,Jn.x,Jn.y,Jn.z)}toNonIndexed(){function e(o,l){let c=o.array,h=o.itemSize,u=o.normalized,f=new c.constructor(l.length*h),d=0,p=0;for(let v=0,m=l.length;v<m;v++){o.isInterleavedBufferAttribute?d=l[v]*o.data.stride+o.offset:d=l[v]*h;for(let g=0;g<h;g++)f[p++]=c[d++]}return new ln(f,h,u)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=e(l,i);t.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=e(f,i);l.push(d)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,h=a.length;c<h;c++){let u=a[c];this.addGroup(u.start,u.count,u.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ru=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Pm,this.updateRanges=[],this.version=0,this.uuid=Rr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=ly(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=ly(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function ly(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Rr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Ei=new P,ws=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?bf(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)Ei.fromBufferAttribute(this,t),Ei.applyMatrix4(e),this.setXYZ(t,Ei.x,Ei.y,Ei.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Ei.fromBufferAttribute(this,t),Ei.applyNormalMatrix(e),this.setXYZ(t,Ei.x,Ei.y,Ei.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Ei.fromBufferAttribute(this,t),Ei.transformDirection(e),this.setXYZ(t,Ei.x,Ei.y,Ei.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){zl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new ln(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){zl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Nm(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Um(e,this.data.array)}},zp=new P,uM=new P,fM=new nt,Ai=class{constructor(e=new P(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=zp.subVectors(i,t).cross(uM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(zp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||fM.getNormalMatrix(e),s=this.coplanarPoint(zp).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},dM=0,Gs=class extends _s{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:dM++}),this.uuid=Rr(),this.name="",this.type="Material",this.blending=Fo,this.side=$s,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=um,this.blendDst=fm,this.blendEquation=Sa,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new qe(0,0,0),this.blendAlpha=0,this.depthFunc=wo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ub,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Xh,this.stencilZFail=Xh,this.stencilZPass=Xh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(i.textures=r),a.length>0&&(i.images=a)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new qe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Ai().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Se().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Se().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var mr=new P,Hp=new P,Sh=new P,Mh=new P,br=class{constructor(e=new P,t=new P(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,mr)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=mr.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(mr.copy(this.origin).addScaledVector(this.direction,t),mr.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Hp.copy(e).add(t).multiplyScalar(.5),Sh.copy(t).sub(e).normalize(),Mh.copy(this.origin).sub(Hp);let r=e.distanceTo(t)*.5,a=-this.direction.dot(Sh),o=Mh.dot(this.direction),l=-Mh.dot(Sh),c=Mh.lengthSq(),h=Math.abs(1-a*a),u,f,d,p;if(h>0)if(u=a*l-o,f=a*o-l,p=r*h,u>=0)if(f>=-p)if(f<=p){let v=1/h;u*=v,f*=v,d=u*(u+a*f+2*o)+f*(a*u+f+2*l)+c}else f=r,u=Math.max(0,-(a*f+o)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(a*f+o)),d=-u*u+f*(f+2*l)+c;else f<=-p?(u=Math.max(0,-(-a*r+o)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=p?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(a*r+o)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=a>0?-r:r,u=Math.max(0,-(a*f+o)),d=-u*u+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Hp).addScaledVector(Sh,f),d}intersectSphere(e,t){if(e.radius<0)return null;mr.subVectors(e.center,this.origin);let i=mr.dot(this.direction),s=mr.dot(mr)-i*i,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=i-a,l=i+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),h>=0?(r=(e.min.y-f.y)*h,a=(e.max.y-f.y)*h):(r=(e.max.y-f.y)*h,a=(e.min.y-f.y)*h),i>a||r>s||((r>i||isNaN(i))&&(i=r),(a<s||isNaN(s))&&(s=a),u>=0?(o=(e.min.z-f.z)*u,l=(e.max.z-f.z)*u):(o=(e.max.z-f.z)*u,l=(e.min.z-f.z)*u),i>l||o>s)||((o>i||i!==i)&&(i=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,mr)!==null}intersectTriangle(e,t,i,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,u=e.x-a.x,f=e.y-a.y,d=e.z-a.z,p=t.x-a.x,v=t.y-a.y,m=t.z-a.z,g=i.x-a.x,y=i.y-a.y,_=i.z-a.z,x=Math.abs(l),T=Math.abs(c),M=Math.abs(h),b,S,C,I,L,O,z,U,G,q,H,le;if(x>=T&&x>=M?(C=l,O=u,G=p,le=g,l>=0?(b=c,S=h,I=f,L=d,z=v,U=m,q=y,H=_):(b=h,S=c,I=d,L=f,z=m,U=v,q=_,H=y)):T>=M?(C=c,O=f,G=v,le=y,c>=0?(b=h,S=l,I=d,L=u,z=m,U=p,q=_,H=g):(b=l,S=h,I=u,L=d,z=p,U=m,q=g,H=_)):(C=h,O=d,G=m,le=_,h>=0?(b=l,S=c,I=u,L=f,z=p,U=v,q=g,H=y):(b=c,S=l,I=f,L=u,z=v,U=p,q=y,H=g)),C===0)return null;let j=b/C,te=S/C,ne=1/C,pe=I-j*O,he=L-te*O,Q=z-j*G,fe=U-te*G,ve=q-j*le,Ee=H-te*le,be=ve*fe-Ee*Q,Xe=pe*Ee-he*ve,ot=Q*he-fe*pe;if(s){if(be<0||Xe<0||ot<0)return null}else if((be<0||Xe<0||ot<0)&&(be>0||Xe>0||ot>0))return null;let Ge=be+Xe+ot;if(Ge===0)return null;let dt=ne*(be*O+Xe*G+ot*le);return(Ge>0?dt<0:dt>0)?null:this.at(dt/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},oi=class extends Gs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new yr,this.combine=Pu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},cy=new St,ba=new br,Eh=new vi,hy=new P,Th=new P,Ah=new P,Rh=new P,Vp=new P,Ch=new P,uy=new P,Ph=new P,zt=class extends dn{constructor(e=new vt,t=new oi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,a=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){Ch.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],u=r[l];h!==0&&(Vp.fromBufferAttribute(u,e),a?Ch.addScaledVector(Vp,h):Ch.addScaledVector(Vp.sub(t),h))}t.add(Ch)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Eh.copy(i.boundingSphere),Eh.applyMatrix4(r),ba.copy(e.ray).recast(e.near),!(Eh.containsPoint(ba.origin)===!1&&(ba.intersectSphere(Eh,hy)===null||ba.origin.distanceToSquared(hy)>(e.far-e.near)**2))&&(cy.copy(r).invert(),ba.copy(e.ray).applyMatrix4(cy),!(i.boundingBox!==null&&ba.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,ba)))}_computeIntersections(e,t,i){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(o!==null)if(Array.isArray(a))for(let p=0,v=f.length;p<v;p++){let m=f[p],g=a[m.materialIndex],y=Math.max(m.start,d.start),_=Math.min(o.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,T=_;x<T;x+=3){let M=o.getX(x),b=o.getX(x+1),S=o.getX(x+2);s=Ih(this,g,e,i,c,h,u,M,b,S),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),v=Math.min(o.count,d.start+d.count);for(let m=p,g=v;m<g;m+=3){let y=o.getX(m),_=o.getX(m+1),x=o.getX(m+2);s=Ih(this,a,e,i,c,h,u,y,_,x),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let p=0,v=f.length;p<v;p++){let m=f[p],g=a[m.materialIndex],y=Math.max(m.start,d.start),_=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let x=y,T=_;x<T;x+=3){let M=x,b=x+1,S=x+2;s=Ih(this,g,e,i,c,h,u,M,b,S),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=p,g=v;m<g;m+=3){let y=m,_=m+1,x=m+2;s=Ih(this,a,e,i,c,h,u,y,_,x),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function pM(n,e,t,i,s,r,a,o){let l;if(e.side===Pi?l=i.intersectTriangle(a,r,s,!0,o):l=i.intersectTriangle(s,r,a,e.side===$s,o),l===null)return null;Ph.copy(o),Ph.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Ph);return c<t.near||c>t.far?null:{distance:c,point:Ph.clone(),object:n}}function Ih(n,e,t,i,s,r,a,o,l,c){n.getVertexPosition(o,Th),n.getVertexPosition(l,Ah),n.getVertexPosition(c,Rh);let h=pM(n,e,t,i,Th,Ah,Rh,uy);if(h){let u=new P;Zr.getBarycoord(uy,Th,Ah,Rh,u),s&&(h.uv=Zr.getInterpolatedAttribute(s,o,l,c,u,new Se)),r&&(h.uv1=Zr.getInterpolatedAttribute(r,o,l,c,u,new Se)),a&&(h.normal=Zr.getInterpolatedAttribute(a,o,l,c,u,new P),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let f={a:o,b:l,c,normal:new P,materialIndex:0};Zr.getNormal(Th,Ah,Rh,f.normal),h.face=f,h.barycoord=u}return h}var xr=class extends Ni{constructor(e=null,t=1,i=1,s,r,a,o,l,c=en,h=en,u,f){super(null,a,o,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Xl=class extends ln{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},mo=new St,fy=new St,Lh=[],dy=new tn,mM=new St,Al=new zt,Rl=new vi,_r=class extends zt{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Xl(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,mM)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new tn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,mo),dy.copy(e.boundingBox).applyMatrix4(mo),this.boundingBox.union(dy)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new vi),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,mo),Rl.copy(e.boundingSphere).applyMatrix4(mo),this.boundingSphere.union(Rl)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,a=e*r+1;for(let o=0;o<i.length;o++)i[o]=s[a+o]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(Al.geometry=this.geometry,Al.material=this.material,Al.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Rl.copy(this.boundingSphere),Rl.applyMatrix4(i),e.ray.intersectsSphere(Rl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,mo),fy.multiplyMatrices(i,mo),Al.matrixWorld=fy,Al.raycast(e,Lh);for(let a=0,o=Lh.length;a<o;a++){let l=Lh[a];l.instanceId=r,l.object=this,t.push(l)}Lh.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Xl(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new xr(new Float32Array(s*this.count),s,this.count,Ou,hs));let r=this.morphTexture.source.data.data,a=0;for(let c=0;c<i.length;c++)a+=i[c];let o=this.geometry.morphTargetsRelative?1:1-a,l=s*e;return r[l]=o,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},xa=new vi,gM=new Se(.5,.5),Dh=new P,Jr=class{constructor(e=new Ai,t=new Ai,i=new Ai,s=new Ai,r=new Ai,a=new Ai){this.planes=[e,t,i,s,r,a]}set(e,t,i,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(i),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=ls,i=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],p=r[8],v=r[9],m=r[10],g=r[11],y=r[12],_=r[13],x=r[14],T=r[15];if(s[0].setComponents(c-a,d-h,g-p,T-y).normalize(),s[1].setComponents(c+a,d+h,g+p,T+y).normalize(),s[2].setComponents(c+o,d+u,g+v,T+_).normalize(),s[3].setComponents(c-o,d-u,g-v,T-_).normalize(),i)s[4].setComponents(l,f,m,x).normalize(),s[5].setComponents(c-l,d-f,g-m,T-x).normalize();else if(s[4].setComponents(c-l,d-f,g-m,T-x).normalize(),t===ls)s[5].setComponents(c+l,d+f,g+m,T+x).normalize();else if(t===So)s[5].setComponents(l,f,m,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),xa.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),xa.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(xa)}intersectsSprite(e){xa.center.set(0,0,0);let t=gM.distanceTo(e.center);return xa.radius=.7071067811865476+t,xa.applyMatrix4(e.matrixWorld),this.intersectsSphere(xa)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Dh.x=s.normal.x>0?e.max.x:e.min.x,Dh.y=s.normal.y>0?e.max.y:e.min.y,Dh.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Dh)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},py=new St,au=class n{constructor(){this.coordinateSystem=ls,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];py.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Jr),i[s].setFromProjectionMatrix(py,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Jr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Ui=class extends Gs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new qe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},ou=new P,lu=new P,my=new St,Cl=new br,Nh=new vi,Gp=new P,gy=new P,Co=class extends dn{constructor(e=new vt,t=new Ui){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)ou.fromBufferAttribute(t,s-1),lu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=ou.distanceTo(lu);e.setAttribute("lineDistance",new tt(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,a=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Nh.copy(i.boundingSphere),Nh.applyMatrix4(s),Nh.radius+=r,e.ray.intersectsSphere(Nh)===!1)return;my.copy(s).invert(),Cl.copy(e.ray).applyMatrix4(my);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=i.index,f=i.attributes.position;if(h!==null){let d=Math.max(0,a.start),p=Math.min(h.count,a.start+a.count);for(let v=d,m=p-1;v<m;v+=c){let g=h.getX(v),y=h.getX(v+1),_=Uh(this,e,Cl,l,g,y,v);_&&t.push(_)}if(this.isLineLoop){let v=h.getX(p-1),m=h.getX(d),g=Uh(this,e,Cl,l,v,m,p-1);g&&t.push(g)}}else{let d=Math.max(0,a.start),p=Math.min(f.count,a.start+a.count);for(let v=d,m=p-1;v<m;v+=c){let g=Uh(this,e,Cl,l,v,v+1,v);g&&t.push(g)}if(this.isLineLoop){let v=Uh(this,e,Cl,l,p-1,d,p-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function Uh(n,e,t,i,s,r,a){let o=n.geometry.attributes.position;if(ou.fromBufferAttribute(o,s),lu.fromBufferAttribute(o,r),t.distanceSqToSegment(ou,lu,Gp,gy)>i)return;Gp.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Gp);if(!(c<e.near||c>e.far))return{distance:c,point:gy.clone().applyMatrix4(n.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:n}}var vy=new P,yy=new P,Ss=class extends Co{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)vy.fromBufferAttribute(t,s),yy.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+vy.distanceTo(yy);e.setAttribute("lineDistance",new tt(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ws=class extends Gs{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new qe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},by=new St,Qp=new br,Fh=new vi,Oh=new P,wr=class extends dn{constructor(e=new vt,t=new Ws){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,a=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Fh.copy(i.boundingSphere),Fh.applyMatrix4(s),Fh.radius+=r,e.ray.intersectsSphere(Fh)===!1)return;by.copy(s).invert(),Qp.copy(e.ray).applyMatrix4(by);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=i.index,u=i.attributes.position;if(c!==null){let f=Math.max(0,a.start),d=Math.min(c.count,a.start+a.count);for(let p=f,v=d;p<v;p++){let m=c.getX(p);Oh.fromBufferAttribute(u,m),xy(Oh,m,l,s,e,t,this)}}else{let f=Math.max(0,a.start),d=Math.min(u.count,a.start+a.count);for(let p=f,v=d;p<v;p++)Oh.fromBufferAttribute(u,p),xy(Oh,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function xy(n,e,t,i,s,r,a){let o=Qp.distanceSqToPoint(n);if(o<t){let l=new P;Qp.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(o),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:a})}}var $l=class extends Ni{constructor(e=[],t=Ma,i,s,r,a,o,l,c,h){super(e,t,i,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ms=class extends Ni{constructor(e,t,i=Ji,s,r,a,o=en,l=en,c,h=vr,u=1){if(h!==vr&&h!==Tr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:u};super(f,s,r,a,o,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new To(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ql=class extends Ms{constructor(e,t=Ji,i=Ma,s,r,a=en,o=en,l,c=vr){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,i,s,r,a,o,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Yl=class extends Ni{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Kr=class n extends vt{constructor(e=1,t=1,i=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],u=[],f=0,d=0;p("z","y","x",-1,-1,i,t,e,a,r,0),p("z","y","x",1,-1,i,t,-e,a,r,1),p("x","z","y",1,1,e,i,t,s,a,2),p("x","z","y",1,-1,e,i,-t,s,a,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new tt(c,3)),this.setAttribute("normal",new tt(h,3)),this.setAttribute("uv",new tt(u,2));function p(v,m,g,y,_,x,T,M,b,S,C){let I=x/b,L=T/S,O=x/2,z=T/2,U=M/2,G=b+1,q=S+1,H=0,le=0,j=new P;for(let te=0;te<q;te++){let ne=te*L-z;for(let pe=0;pe<G;pe++){let he=pe*I-O;j[v]=he*y,j[m]=ne*_,j[g]=U,c.push(j.x,j.y,j.z),j[v]=0,j[m]=0,j[g]=M>0?1:-1,h.push(j.x,j.y,j.z),u.push(pe/b),u.push(1-te/S),H+=1}}for(let te=0;te<S;te++)for(let ne=0;ne<b;ne++){let pe=f+ne+G*te,he=f+ne+G*(te+1),Q=f+(ne+1)+G*(te+1),fe=f+(ne+1)+G*te;l.push(pe,he,fe),l.push(he,Q,fe),le+=6}o.addGroup(d,le,C),d+=le,f+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Sr=class n extends vt{constructor(e=1,t=1,i=1,s=32,r=1,a=!1,o=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],p=0,v=[],m=i/2,g=0;y(),a===!1&&(e>0&&_(!0),t>0&&_(!1)),this.setIndex(h),this.setAttribute("position",new tt(u,3)),this.setAttribute("normal",new tt(f,3)),this.setAttribute("uv",new tt(d,2));function y(){let x=new P,T=new P,M=0,b=(t-e)/i;for(let S=0;S<=r;S++){let C=[],I=S/r,L=I*(t-e)+e;for(let O=0;O<=s;O++){let z=O/s,U=z*l+o,G=Math.sin(U),q=Math.cos(U);T.x=L*G,T.y=-I*i+m,T.z=L*q,u.push(T.x,T.y,T.z),x.set(G,b,q).normalize(),f.push(x.x,x.y,x.z),d.push(z,1-I),C.push(p++)}v.push(C)}for(let S=0;S<s;S++)for(let C=0;C<r;C++){let I=v[C][S],L=v[C+1][S],O=v[C+1][S+1],z=v[C][S+1];(e>0||C!==0)&&(h.push(I,L,z),M+=3),(t>0||C!==r-1)&&(h.push(L,O,z),M+=3)}c.addGroup(g,M,0),g+=M}function _(x){let T=p,M=new Se,b=new P,S=0,C=x===!0?e:t,I=x===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,m*I,0),f.push(0,I,0),d.push(.5,.5),p++;let L=p;for(let O=0;O<=s;O++){let U=O/s*l+o,G=Math.cos(U),q=Math.sin(U);b.x=C*q,b.y=m*I,b.z=C*G,u.push(b.x,b.y,b.z),f.push(0,I,0),M.x=G*.5+.5,M.y=q*.5*I+.5,d.push(M.x,M.y),p++}for(let O=0;O<s;O++){let z=T+O,U=L+O;x===!0?h.push(U,U+1,z):h.push(U+1,U,z),S+=3}c.addGroup(g,S,x===!0?1:2),g+=S}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},jl=class n extends Sr{constructor(e=1,t=1,i=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,e,t,i,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},cu=class n extends vt{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};let r=[],a=[];o(s),c(i),h(),this.setAttribute("position",new tt(r,3)),this.setAttribute("normal",new tt(r.slice(),3)),this.setAttribute("uv",new tt(a,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function o(y){let _=new P,x=new P,T=new P;for(let M=0;M<t.length;M+=3)d(t[M+0],_),d(t[M+1],x),d(t[M+2],T),l(_,x,T,y)}function l(y,_,x,T){let M=T+1,b=[];for(let S=0;S<=M;S++){b[S]=[];let C=y.clone().lerp(x,S/M),I=_.clone().lerp(x,S/M),L=M-S;for(let O=0;O<=L;O++)O===0&&S===M?b[S][O]=C:b[S][O]=C.clone().lerp(I,O/L)}for(let S=0;S<M;S++)for(let C=0;C<2*(M-S)-1;C++){let I=Math.floor(C/2);C%2===0?(f(b[S][I+1]),f(b[S+1][I]),f(b[S][I])):(f(b[S][I+1]),f(b[S+1][I+1]),f(b[S+1][I]))}}function c(y){let _=new P;for(let x=0;x<r.length;x+=3)_.x=r[x+0],_.y=r[x+1],_.z=r[x+2],_.normalize().multiplyScalar(y),r[x+0]=_.x,r[x+1]=_.y,r[x+2]=_.z}function h(){let y=new P;for(let _=0;_<r.length;_+=3){y.x=r[_+0],y.y=r[_+1],y.z=r[_+2];let x=m(y)/2/Math.PI+.5,T=g(y)/Math.PI+.5;a.push(x,1-T)}p(),u()}function u(){for(let y=0;y<a.length;y+=6){let _=a[y+0],x=a[y+2],T=a[y+4],M=Math.max(_,x,T),b=Math.min(_,x,T);M>.9&&b<.1&&(_<.2&&(a[y+0]+=1),x<.2&&(a[y+2]+=1),T<.2&&(a[y+4]+=1))}}function f(y){r.push(y.x,y.y,y.z)}function d(y,_){let x=y*3;_.x=e[x+0],_.y=e[x+1],_.z=e[x+2]}function p(){let y=new P,_=new P,x=new P,T=new P,M=new Se,b=new Se,S=new Se;for(let C=0,I=0;C<r.length;C+=9,I+=6){y.set(r[C+0],r[C+1],r[C+2]),_.set(r[C+3],r[C+4],r[C+5]),x.set(r[C+6],r[C+7],r[C+8]),M.set(a[I+0],a[I+1]),b.set(a[I+2],a[I+3]),S.set(a[I+4],a[I+5]),T.copy(y).add(_).add(x).divideScalar(3);let L=m(T);v(M,I+0,y,L),v(b,I+2,_,L),v(S,I+4,x,L)}}function v(y,_,x,T){T<0&&y.x===1&&(a[_]=y.x-1),x.x===0&&x.z===0&&(a[_]=T/2/Math.PI+.5)}function m(y){return Math.atan2(y.z,-y.x)}function g(y){return Math.atan2(-y.y,Math.sqrt(y.x*y.x+y.z*y.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.vertices,e.indices,e.radius,e.detail)}};var Yi=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Je("Curve: .getPoint() not implemented.")}getPointAt(e,t){let i=this.getUtoTmapping(e);return this.getPoint(i,t)}getPoints(e=5){let t=[];for(let i=0;i<=e;i++)t.push(this.getPoint(i/e));return t}getSpacedPoints(e=5){let t=[];for(let i=0;i<=e;i++)t.push(this.getPointAt(i/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],i,s=this.getPoint(0),r=0;t.push(0);for(let a=1;a<=e;a++)i=this.getPoint(a/e),r+=i.distanceTo(s),t.push(r),s=i;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let i=this.getLengths(),s=0,r=i.length,a;t?a=t:a=e*i[r-1];let o=0,l=r-1,c;for(;o<=l;)if(s=Math.floor(o+(l-o)/2),c=i[s]-a,c<0)o=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,i[s]===a)return s/(r-1);let h=i[s],f=i[s+1]-h,d=(a-h)/f;return(s+d)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let a=this.getPoint(s),o=this.getPoint(r),l=t||(a.isVector2?new Se:new P);return l.copy(o).sub(a).normalize(),l}getTangentAt(e,t){let i=this.getUtoTmapping(e);return this.getTangent(i,t)}computeFrenetFrames(e,t=!1){let i=new P,s=[],r=[],a=[],o=new P,l=new St;for(let d=0;d<=e;d++){let p=d/e;s[d]=this.getTangentAt(p,new P)}r[0]=new P,a[0]=new P;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),f=Math.abs(s[0].z);h<=c&&(c=h,i.set(1,0,0)),u<=c&&(c=u,i.set(0,1,0)),f<=c&&i.set(0,0,1),o.crossVectors(s[0],i).normalize(),r[0].crossVectors(s[0],o),a[0].crossVectors(s[0],r[0]);for(let d=1;d<=e;d++){if(r[d]=r[d-1].clone(),a[d]=a[d-1].clone(),o.crossVectors(s[d-1],s[d]),o.length()>Number.EPSILON){o.normalize();let p=Math.acos(ct(s[d-1].dot(s[d]),-1,1));r[d].applyMatrix4(l.makeRotationAxis(o,p))}a[d].crossVectors(s[d],r[d])}if(t===!0){let d=Math.acos(ct(r[0].dot(r[e]),-1,1));d/=e,s[0].dot(o.crossVectors(r[0],r[e]))>0&&(d=-d);for(let p=1;p<=e;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],d*p)),a[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:a}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},Po=class extends Yi{constructor(e=0,t=0,i=1,s=1,r=0,a=Math.PI*2,o=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=i,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=a,this.aClockwise=o,this.aRotation=l}getPoint(e,t=new Se){let i=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,a=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(a?r=0:r=s),this.aClockwise===!0&&!a&&(r===s?r=-s:r=r-s);let o=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(o),c=this.aY+this.yRadius*Math.sin(o);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),f=l-this.aX,d=c-this.aY;l=f*h-d*u+this.aX,c=f*u+d*h+this.aY}return i.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},hu=class extends Po{constructor(e,t,i,s,r,a){super(e,t,i,i,s,r,a),this.isArcCurve=!0,this.type="ArcCurve"}};function Fm(){let n=0,e=0,t=0,i=0;function s(r,a,o,l){n=r,e=o,t=-3*r+3*a-2*o-l,i=2*r-2*a+o+l}return{initCatmullRom:function(r,a,o,l,c){s(a,o,c*(o-r),c*(l-a))},initNonuniformCatmullRom:function(r,a,o,l,c,h,u){let f=(a-r)/c-(o-r)/(c+h)+(o-a)/h,d=(o-a)/h-(l-a)/(h+u)+(l-o)/u;f*=h,d*=h,s(a,o,f,d)},calc:function(r){let a=r*r,o=a*r;return n+e*r+t*a+i*o}}}var _y=new P,wy=new P,Wp=new Fm,Xp=new Fm,$p=new Fm,_a=class extends Yi{constructor(e=[],t=!1,i="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=i,this.tension=s}getPoint(e,t=new P){let i=t,s=this.points,r=s.length,a=(r-(this.closed?0:1))*e,o=Math.floor(a),l=a-o;this.closed?o+=o>0?0:(Math.floor(Math.abs(o)/r)+1)*r:l===0&&o===r-1&&(o=r-2,l=1);let c,h;this.closed||o>0?c=s[(o-1)%r]:(wy.subVectors(s[0],s[1]).add(s[0]),c=wy);let u=s[o%r],f=s[(o+1)%r];if(this.closed||o+2<r?h=s[(o+2)%r]:(_y.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=_y),this.curveType==="centripetal"||this.curveType==="chordal"){let d=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),d),v=Math.pow(u.distanceToSquared(f),d),m=Math.pow(f.distanceToSquared(h),d);v<1e-4&&(v=1),p<1e-4&&(p=v),m<1e-4&&(m=v),Wp.initNonuniformCatmullRom(c.x,u.x,f.x,h.x,p,v,m),Xp.initNonuniformCatmullRom(c.y,u.y,f.y,h.y,p,v,m),$p.initNonuniformCatmullRom(c.z,u.z,f.z,h.z,p,v,m)}else this.curveType==="catmullrom"&&(Wp.initCatmullRom(c.x,u.x,f.x,h.x,this.tension),Xp.initCatmullRom(c.y,u.y,f.y,h.y,this.tension),$p.initCatmullRom(c.z,u.z,f.z,h.z,this.tension));return i.set(Wp.calc(l),Xp.calc(l),$p.calc(l)),i}copy(e){super.copy(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,i=this.points.length;t<i;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let s=e.points[t];this.points.push(new P().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function Sy(n,e,t,i,s){let r=(i-e)*.5,a=(s-t)*.5,o=n*n,l=n*o;return(2*t-2*i+r+a)*l+(-3*t+3*i-2*r-a)*o+r*n+t}function vM(n,e){let t=1-n;return t*t*e}function yM(n,e){return 2*(1-n)*n*e}function bM(n,e){return n*n*e}function Nl(n,e,t,i){return vM(n,e)+yM(n,t)+bM(n,i)}function xM(n,e){let t=1-n;return t*t*t*e}function _M(n,e){let t=1-n;return 3*t*t*n*e}function wM(n,e){return 3*(1-n)*n*n*e}function SM(n,e){return n*n*n*e}function Ul(n,e,t,i,s){return xM(n,e)+_M(n,t)+wM(n,i)+SM(n,s)}var Zl=class extends Yi{constructor(e=new Se,t=new Se,i=new Se,s=new Se){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=i,this.v3=s}getPoint(e,t=new Se){let i=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return i.set(Ul(e,s.x,r.x,a.x,o.x),Ul(e,s.y,r.y,a.y,o.y)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},uu=class extends Yi{constructor(e=new P,t=new P,i=new P,s=new P){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=i,this.v3=s}getPoint(e,t=new P){let i=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return i.set(Ul(e,s.x,r.x,a.x,o.x),Ul(e,s.y,r.y,a.y,o.y),Ul(e,s.z,r.z,a.z,o.z)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Jl=class extends Yi{constructor(e=new Se,t=new Se){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Se){let i=t;return e===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(e).add(this.v1)),i}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Se){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},fu=class extends Yi{constructor(e=new P,t=new P){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new P){let i=t;return e===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(e).add(this.v1)),i}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new P){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Kl=class extends Yi{constructor(e=new Se,t=new Se,i=new Se){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=i}getPoint(e,t=new Se){let i=t,s=this.v0,r=this.v1,a=this.v2;return i.set(Nl(e,s.x,r.x,a.x),Nl(e,s.y,r.y,a.y)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},du=class extends Yi{constructor(e=new P,t=new P,i=new P){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=i}getPoint(e,t=new P){let i=t,s=this.v0,r=this.v1,a=this.v2;return i.set(Nl(e,s.x,r.x,a.x),Nl(e,s.y,r.y,a.y),Nl(e,s.z,r.z,a.z)),i}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Ql=class extends Yi{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Se){let i=t,s=this.points,r=(s.length-1)*e,a=Math.floor(r),o=r-a,l=s[a===0?a:a-1],c=s[a],h=s[a>s.length-2?s.length-1:a+1],u=s[a>s.length-3?s.length-1:a+2];return i.set(Sy(o,l.x,c.x,h.x,u.x),Sy(o,l.y,c.y,h.y,u.y)),i}copy(e){super.copy(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,i=this.points.length;t<i;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,i=e.points.length;t<i;t++){let s=e.points[t];this.points.push(new Se().fromArray(s))}return this}},My=Object.freeze({__proto__:null,ArcCurve:hu,CatmullRomCurve3:_a,CubicBezierCurve:Zl,CubicBezierCurve3:uu,EllipseCurve:Po,LineCurve:Jl,LineCurve3:fu,QuadraticBezierCurve:Kl,QuadraticBezierCurve3:du,SplineCurve:Ql}),pu=class extends Yi{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let i=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new My[i](t,e))}return this}getPoint(e,t){let i=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=i){let a=s[r]-i,o=this.curves[r],l=o.getLength(),c=l===0?0:1-a/l;return o.getPointAt(c,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let i=0,s=this.curves.length;i<s;i++)t+=this.curves[i].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let i=0;i<=e;i++)t.push(this.getPoint(i/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],i;for(let s=0,r=this.curves;s<r.length;s++){let a=r[s],o=a.isEllipseCurve?e*2:a.isLineCurve||a.isLineCurve3?1:a.isSplineCurve?e*a.points.length:e,l=a.getPoints(o);for(let c=0;c<l.length;c++){let h=l[c];i&&i.equals(h)||(t.push(h),i=h)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,i=e.curves.length;t<i;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this.cacheLengths=null,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,i=this.curves.length;t<i;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,i=e.curves.length;t<i;t++){let s=e.curves[t];this.curves.push(new My[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},ec=class extends pu{constructor(e){super(),this.type="Path",this.currentPoint=new Se,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,i=e.length;t<i;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let i=new Jl(this.currentPoint.clone(),new Se(e,t));return this.curves.push(i),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,i,s){let r=new Kl(this.currentPoint.clone(),new Se(e,t),new Se(i,s));return this.curves.push(r),this.currentPoint.set(i,s),this}bezierCurveTo(e,t,i,s,r,a){let o=new Zl(this.currentPoint.clone(),new Se(e,t),new Se(i,s),new Se(r,a));return this.curves.push(o),this.currentPoint.set(r,a),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),i=new Ql(t);return this.curves.push(i),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,i,s,r,a){let o=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+o,t+l,i,s,r,a),this}absarc(e,t,i,s,r,a){return this.absellipse(e,t,i,i,s,r,a),this}ellipse(e,t,i,s,r,a,o,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(e+c,t+h,i,s,r,a,o,l),this}absellipse(e,t,i,s,r,a,o,l){let c=new Po(e,t,i,s,r,a,o,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},Io=class extends ec{constructor(e){super(e),this.uuid=Rr(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let i=0,s=this.holes.length;i<s;i++)t[i]=this.holes[i].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,i=e.holes.length;t<i;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,i=this.holes.length;t<i;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,i=e.holes.length;t<i;t++){let s=e.holes[t];this.holes.push(new ec().fromJSON(s))}return this}};function MM(n,e,t=2){let i=e&&e.length,s=i?e[0]*t:n.length,r=wb(n,0,s,t,!0),a=[];if(!r||r.next===r.prev)return a;let o,l,c;if(i&&(r=CM(n,e,r,t)),n.length>80*t){o=n[0],l=n[1];let h=o,u=l;for(let f=t;f<s;f+=t){let d=n[f],p=n[f+1];d<o&&(o=d),p<l&&(l=p),d>h&&(h=d),p>u&&(u=p)}c=Math.max(h-o,u-l),c=c!==0?32767/c:0}return tc(r,a,t,o,l,c,0),a}function wb(n,e,t,i,s){let r;if(s===zM(n,e,t,i)>0)for(let a=e;a<t;a+=i)r=Ey(a/i|0,n[a],n[a+1],r);else for(let a=t-i;a>=e;a-=i)r=Ey(a/i|0,n[a],n[a+1],r);return r&&Lo(r,r.next)&&(ic(r),r=r.next),r}function wa(n,e){if(!n)return n;e||(e=n);let t=n,i;do if(i=!1,!t.steiner&&(Lo(t,t.next)||gn(t.prev,t,t.next)===0)){if(ic(t),t=e=t.prev,t===t.next)break;i=!0}else t=t.next;while(i||t!==e);return e}function tc(n,e,t,i,s,r,a){if(!n)return;!a&&r&&NM(n,i,s,r);let o=n;for(;n.prev!==n.next;){let l=n.prev,c=n.next;if(r?TM(n,i,s,r):EM(n)){e.push(l.i,n.i,c.i),ic(n),n=c.next,o=c.next;continue}if(n=c,n===o){a?a===1?(n=AM(wa(n),e),tc(n,e,t,i,s,r,2)):a===2&&RM(n,e,t,i,s,r):tc(wa(n),e,t,i,s,r,1);break}}}function EM(n){let e=n.prev,t=n,i=n.next;if(gn(e,t,i)>=0)return!1;let s=e.x,r=t.x,a=i.x,o=e.y,l=t.y,c=i.y,h=Math.min(s,r,a),u=Math.min(o,l,c),f=Math.max(s,r,a),d=Math.max(o,l,c),p=i.next;for(;p!==e;){if(p.x>=h&&p.x<=f&&p.y>=u&&p.y<=d&&Pl(s,o,r,l,a,c,p.x,p.y)&&gn(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function TM(n,e,t,i){let s=n.prev,r=n,a=n.next;if(gn(s,r,a)>=0)return!1;let o=s.x,l=r.x,c=a.x,h=s.y,u=r.y,f=a.y,d=Math.min(o,l,c),p=Math.min(h,u,f),v=Math.max(o,l,c),m=Math.max(h,u,f),g=em(d,p,e,t,i),y=em(v,m,e,t,i),_=n.prevZ,x=n.nextZ;for(;_&&_.z>=g&&x&&x.z<=y;){if(_.x>=d&&_.x<=v&&_.y>=p&&_.y<=m&&_!==s&&_!==a&&Pl(o,h,l,u,c,f,_.x,_.y)&&gn(_.prev,_,_.next)>=0||(_=_.prevZ,x.x>=d&&x.x<=v&&x.y>=p&&x.y<=m&&x!==s&&x!==a&&Pl(o,h,l,u,c,f,x.x,x.y)&&gn(x.prev,x,x.next)>=0))return!1;x=x.nextZ}for(;_&&_.z>=g;){if(_.x>=d&&_.x<=v&&_.y>=p&&_.y<=m&&_!==s&&_!==a&&Pl(o,h,l,u,c,f,_.x,_.y)&&gn(_.prev,_,_.next)>=0)return!1;_=_.prevZ}for(;x&&x.z<=y;){if(x.x>=d&&x.x<=v&&x.y>=p&&x.y<=m&&x!==s&&x!==a&&Pl(o,h,l,u,c,f,x.x,x.y)&&gn(x.prev,x,x.next)>=0)return!1;x=x.nextZ}return!0}function AM(n,e){let t=n;do{let i=t.prev,s=t.next.next;!Lo(i,s)&&Mb(i,t,t.next,s)&&nc(i,s)&&nc(s,i)&&(e.push(i.i,t.i,s.i),ic(t),ic(t.next),t=n=s),t=t.next}while(t!==n);return wa(t)}function RM(n,e,t,i,s,r){let a=n;do{let o=a.next.next;for(;o!==a.prev;){if(a.i!==o.i&&OM(a,o)){let l=Eb(a,o);a=wa(a,a.next),l=wa(l,l.next),tc(a,e,t,i,s,r,0),tc(l,e,t,i,s,r,0);return}o=o.next}a=a.next}while(a!==n)}function CM(n,e,t,i){let s=[];for(let r=0,a=e.length;r<a;r++){let o=e[r]*i,l=r<a-1?e[r+1]*i:n.length,c=wb(n,o,l,i,!1);c===c.next&&(c.steiner=!0),s.push(FM(c))}s.sort(PM);for(let r=0;r<s.length;r++)t=IM(s[r],t);return t}function PM(n,e){let t=n.x-e.x;if(t===0&&(t=n.y-e.y,t===0)){let i=(n.next.y-n.y)/(n.next.x-n.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=i-s}return t}function IM(n,e){let t=LM(n,e);if(!t)return e;let i=Eb(t,n);return wa(i,i.next),wa(t,t.next)}function LM(n,e){let t=e,i=n.x,s=n.y,r=-1/0,a;if(Lo(n,t))return t;do{if(Lo(n,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let u=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(u<=i&&u>r&&(r=u,a=t.x<t.next.x?t:t.next,u===i))return a}t=t.next}while(t!==e);if(!a)return null;let o=a,l=a.x,c=a.y,h=1/0;t=a;do{if(i>=t.x&&t.x>=l&&i!==t.x&&Sb(s<c?i:r,s,l,c,s<c?r:i,s,t.x,t.y)){let u=Math.abs(s-t.y)/(i-t.x);nc(t,n)&&(u<h||u===h&&(t.x>a.x||t.x===a.x&&DM(a,t)))&&(a=t,h=u)}t=t.next}while(t!==o);return a}function DM(n,e){return gn(n.prev,n,e.prev)<0&&gn(e.next,n,n.next)<0}function NM(n,e,t,i){let s=n;do s.z===0&&(s.z=em(s.x,s.y,e,t,i)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==n);s.prevZ.nextZ=null,s.prevZ=null,UM(s)}function UM(n){let e,t=1;do{let i=n,s;n=null;let r=null;for(e=0;i;){e++;let a=i,o=0;for(let c=0;c<t&&(o++,a=a.nextZ,!!a);c++);let l=t;for(;o>0||l>0&&a;)o!==0&&(l===0||!a||i.z<=a.z)?(s=i,i=i.nextZ,o--):(s=a,a=a.nextZ,l--),r?r.nextZ=s:n=s,s.prevZ=r,r=s;i=a}r.nextZ=null,t*=2}while(e>1);return n}function em(n,e,t,i,s){return n=(n-t)*s|0,e=(e-i)*s|0,n=(n|n<<8)&16711935,n=(n|n<<4)&252645135,n=(n|n<<2)&858993459,n=(n|n<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,n|e<<1}function FM(n){let e=n,t=n;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==n);return t}function Sb(n,e,t,i,s,r,a,o){return(s-a)*(e-o)>=(n-a)*(r-o)&&(n-a)*(i-o)>=(t-a)*(e-o)&&(t-a)*(r-o)>=(s-a)*(i-o)}function Pl(n,e,t,i,s,r,a,o){return!(n===a&&e===o)&&Sb(n,e,t,i,s,r,a,o)}function OM(n,e){return n.next.i!==e.i&&n.prev.i!==e.i&&!kM(n,e)&&(nc(n,e)&&nc(e,n)&&BM(n,e)&&(gn(n.prev,n,e.prev)||gn(n,e.prev,e))||Lo(n,e)&&gn(n.prev,n,n.next)>0&&gn(e.prev,e,e.next)>0)}function gn(n,e,t){return(e.y-n.y)*(t.x-e.x)-(e.x-n.x)*(t.y-e.y)}function Lo(n,e){return n.x===e.x&&n.y===e.y}function Mb(n,e,t,i){let s=Bh(gn(n,e,t)),r=Bh(gn(n,e,i)),a=Bh(gn(t,i,n)),o=Bh(gn(t,i,e));return!!(s!==r&&a!==o||s===0&&kh(n,t,e)||r===0&&kh(n,i,e)||a===0&&kh(t,n,i)||o===0&&kh(t,e,i))}function kh(n,e,t){return e.x<=Math.max(n.x,t.x)&&e.x>=Math.min(n.x,t.x)&&e.y<=Math.max(n.y,t.y)&&e.y>=Math.min(n.y,t.y)}function Bh(n){return n>0?1:n<0?-1:0}function kM(n,e){let t=n;do{if(t.i!==n.i&&t.next.i!==n.i&&t.i!==e.i&&t.next.i!==e.i&&Mb(t,t.next,n,e))return!0;t=t.next}while(t!==n);return!1}function nc(n,e){return gn(n.prev,n,n.next)<0?gn(n,e,n.next)>=0&&gn(n,n.prev,e)>=0:gn(n,e,n.prev)<0||gn(n,n.next,e)<0}function BM(n,e){let t=n,i=!1,s=(n.x+e.x)/2,r=(n.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(i=!i),t=t.next;while(t!==n);return i}function Eb(n,e){let t=tm(n.i,n.x,n.y),i=tm(e.i,e.x,e.y),s=n.next,r=e.prev;return n.next=e,e.prev=n,t.next=s,s.prev=t,i.next=t,t.prev=i,r.next=i,i.prev=r,i}function Ey(n,e,t,i){let s=tm(n,e,t);return i?(s.next=i.next,s.prev=i,i.next.prev=s,i.next=s):(s.prev=s,s.next=s),s}function ic(n){n.next.prev=n.prev,n.prev.next=n.next,n.prevZ&&(n.prevZ.nextZ=n.nextZ),n.nextZ&&(n.nextZ.prevZ=n.prevZ)}function tm(n,e,t){return{i:n,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function zM(n,e,t,i){let s=0;for(let r=e,a=t-i;r<t;r+=i)s+=(n[a]-n[r])*(n[r+1]+n[a+1]),a=r;return s}var nm=class{static triangulate(e,t,i=2){return MM(e,t,i)}},Vs=class n{static area(e){let t=e.length,i=0;for(let s=t-1,r=0;r<t;s=r++)i+=e[s].x*e[r].y-e[r].x*e[s].y;return i*.5}static isClockWise(e){return n.area(e)<0}static triangulateShape(e,t){let i=[],s=[],r=[];Ty(e),Ay(i,e);let a=e.length;t.forEach(Ty);for(let l=0;l<t.length;l++)s.push(a),a+=t[l].length,Ay(i,t[l]);let o=nm.triangulate(i,s);for(let l=0;l<o.length;l+=3)r.push(o.slice(l,l+3));return r}};function Ty(n){let e=n.length;e>2&&n[e-1].equals(n[0])&&n.pop()}function Ay(n,e){for(let t=0;t<e.length;t++)n.push(e[t].x),n.push(e[t].y)}var sc=class n extends cu{constructor(e=1,t=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new n(e.radius,e.detail)}},rc=class n extends vt{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(i),l=Math.floor(s),c=o+1,h=l+1,u=e/o,f=t/l,d=[],p=[],v=[],m=[];for(let g=0;g<h;g++){let y=g*f-a;for(let _=0;_<c;_++){let x=_*u-r;p.push(x,-y,0),v.push(0,0,1),m.push(_/o),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<o;y++){let _=y+c*g,x=y+c*(g+1),T=y+1+c*(g+1),M=y+1+c*g;d.push(_,x,M),d.push(x,T,M)}this.setIndex(d),this.setAttribute("position",new tt(p,3)),this.setAttribute("normal",new tt(v,3)),this.setAttribute("uv",new tt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var ac=class n extends vt{constructor(e=new Io([new Se(0,.5),new Se(-.5,-.5),new Se(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let i=[],s=[],r=[],a=[],o=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let h=0;h<e.length;h++)c(e[h]),this.addGroup(o,l,h),o+=l,l=0;this.setIndex(i),this.setAttribute("position",new tt(s,3)),this.setAttribute("normal",new tt(r,3)),this.setAttribute("uv",new tt(a,2));function c(h){let u=s.length/3,f=h.extractPoints(t),d=f.shape,p=f.holes;Vs.isClockWise(d)===!1&&(d=d.reverse());for(let m=0,g=p.length;m<g;m++){let y=p[m];Vs.isClockWise(y)===!0&&(p[m]=y.reverse())}let v=Vs.triangulateShape(d,p);for(let m=0,g=p.length;m<g;m++){let y=p[m];d=d.concat(y)}for(let m=0,g=d.length;m<g;m++){let y=d[m];s.push(y.x,y.y,0),r.push(0,0,1),a.push(y.x,y.y)}for(let m=0,g=v.length;m<g;m++){let y=v[m],_=y[0]+u,x=y[1]+u,T=y[2]+u;i.push(_,x,T),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return HM(t,e)}static fromJSON(e,t){let i=[];for(let s=0,r=e.shapes.length;s<r;s++){let a=t[e.shapes[s]];i.push(a)}return new n(i,e.curveSegments)}};function HM(n,e){if(e.shapes=[],Array.isArray(n))for(let t=0,i=n.length;t<i;t++){let s=n[t];e.shapes.push(s.uuid)}else e.shapes.push(n.uuid);return e}var oc=class extends vt{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new P,r=new P;if(e.index!==null){let a=e.attributes.position,o=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:o.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let u=l[c],f=u.start,d=u.count;for(let p=f,v=f+d;p<v;p+=3)for(let m=0;m<3;m++){let g=o.getX(p+m),y=o.getX(p+(m+1)%3);s.fromBufferAttribute(a,g),r.fromBufferAttribute(a,y),Ry(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let a=e.attributes.position;for(let o=0,l=a.count/3;o<l;o++)for(let c=0;c<3;c++){let h=3*o+c,u=3*o+(c+1)%3;s.fromBufferAttribute(a,h),r.fromBufferAttribute(a,u),Ry(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new tt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function Ry(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}function Ta(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Cy(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Cy(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function yi(n){let e={};for(let t=0;t<n.length;t++){let i=Ta(n[t]);for(let s in i)e[s]=i[s]}return e}function Cy(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function VM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Om(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Et.workingColorSpace}var Tc={clone:Ta,merge:yi},GM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,WM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Fi=class extends Gs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=GM,this.fragmentShader=WM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ta(e.uniforms),this.uniformsGroups=VM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new qe().setHex(s.value);break;case"v2":this.uniforms[i].value=new Se().fromArray(s.value);break;case"v3":this.uniforms[i].value=new P().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Bt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new St().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},mu=class extends Fi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Xs=class extends Gs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=yf,this.normalScale=new Se(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new yr,this.combine=Pu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},gu=class extends Gs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=cb,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},vu=class extends Gs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function go(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function zh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Qr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let a;t:{i:if(!(e<s)){for(let o=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===o)break;if(r=s,s=t[++i],e<s)break e}a=t.length;break t}if(!(e>=r)){let o=t[1];e<o&&(i=2,r=o);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}a=i,i=0;break t}break n}for(;i<a;){let o=i+a>>>1;e<t[o]?a=o:i=o+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=i[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},yu=class extends Qr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Zp,endingEnd:Zp}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Jp:r=e,o=2*t-i;break;case Kp:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Jp:a=e,l=2*i-t;break;case Kp:a=1,l=i+s[1]-s[0];break;default:a=e-1,l=t}let c=(i-t)*.5,h=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(e,t,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),v=p*p,m=v*p,g=-f*m+2*f*v-f*p,y=(1+f)*m+(-1.5-2*f)*v+(-.5+f)*p+1,_=(-1-d)*m+(1.5+d)*v+.5*p,x=d*m-d*v;for(let T=0;T!==o;++T)r[T]=g*a[h+T]+y*a[c+T]+_*a[l+T]+x*a[u+T];return r}},bu=class extends Qr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=(i-t)/(s-t),u=1-h;for(let f=0;f!==o;++f)r[f]=a[c+f]*u+a[l+f]*h;return r}},xu=class extends Qr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},_u=class extends Qr{interpolate_(e,t,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(i-t)/(s-t),v=1-p;for(let m=0;m!==o;++m)r[m]=a[c+m]*v+a[l+m]*p;return r}let f=o*2,d=e-1;for(let p=0;p!==o;++p){let v=a[c+p],m=a[l+p],g=d*f+p*2,y=u[g],_=u[g+1],x=e*f+p*2,T=h[x],M=h[x+1],b=$M(i,t,y,T,s);r[p]=Tb(b,v,_,M,m)}return r}};function Tb(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function XM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function $M(n,e,t,i,s){let r=(n-e)/(s-e);for(let a=0;a<8;a++){let o=Tb(r,e,t,i,s)-n;if(Math.abs(o)<1e-10)break;let l=XM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var ji=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=go(t,this.TimeBufferType),this.values=go(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:go(e.times,Array),values:go(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),zh(e.settings)&&(i.settings={inTangents:go(e.settings.inTangents,Array),outTangents:go(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new xu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new bu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new yu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new _u(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Fl:t=this.InterpolantFactoryMethodDiscrete;break;case tu:t=this.InterpolantFactoryMethodLinear;break;case Wh:t=this.InterpolantFactoryMethodSmooth;break;case jp:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Fl;case this.InterpolantFactoryMethodLinear:return tu;case this.InterpolantFactoryMethodSmooth:return Wh;case this.InterpolantFactoryMethodBezier:return jp}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;zh(this.settings)&&(Py(this.settings.inTangents,e),Py(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;zh(this.settings)&&(Iy(this.settings.inTangents,e),Iy(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,a=s-1;for(;r!==s&&i[r]<e;)++r;for(;a!==-1&&i[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=i.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(rt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(rt("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let l=i[o];if(typeof l=="number"&&isNaN(l)){rt("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){rt("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(s!==void 0&&FS(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){rt("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Wh,r=e.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=e[o],h=e[o+1];if(c!==h&&(o!==1||c!==e[0]))if(s)l=!0;else{let u=o*i,f=u-i,d=u+i;for(let p=0;p!==i;++p){let v=t[u+p];if(v!==t[f+p]||v!==t[d+p]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let u=o*i,f=a*i;for(let d=0;d!==i;++d)t[f+d]=t[u+d]}++a}}if(r>0){e[a]=e[r];for(let o=r*i,l=a*i,c=0;c!==i;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,zh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Py(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Iy(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}ji.prototype.ValueTypeName="";ji.prototype.TimeBufferType=Float32Array;ji.prototype.ValueBufferType=Float32Array;ji.prototype.DefaultInterpolation=tu;var ea=class extends ji{constructor(e,t,i){super(e,t,i)}};ea.prototype.ValueTypeName="bool";ea.prototype.ValueBufferType=Array;ea.prototype.DefaultInterpolation=Fl;ea.prototype.InterpolantFactoryMethodLinear=void 0;ea.prototype.InterpolantFactoryMethodSmooth=void 0;var wu=class extends ji{constructor(e,t,i,s){super(e,t,i,s)}};wu.prototype.ValueTypeName="color";var Su=class extends ji{constructor(e,t,i,s){super(e,t,i,s)}};Su.prototype.ValueTypeName="number";var Mu=class extends Qr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(i-t)/(s-t),c=e*o;for(let h=c+o;c!==h;c+=4)Ci.slerpFlat(r,0,a,c-o,a,c,l);return r}},lc=class extends ji{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Mu(this.times,this.values,this.getValueSize(),e)}};lc.prototype.ValueTypeName="quaternion";lc.prototype.InterpolantFactoryMethodSmooth=void 0;var ta=class extends ji{constructor(e,t,i){super(e,t,i)}};ta.prototype.ValueTypeName="string";ta.prototype.ValueBufferType=Array;ta.prototype.DefaultInterpolation=Fl;ta.prototype.InterpolantFactoryMethodLinear=void 0;ta.prototype.InterpolantFactoryMethodSmooth=void 0;var Eu=class extends ji{constructor(e,t,i,s){super(e,t,i,s)}};Eu.prototype.ValueTypeName="vector";var Tu=class{constructor(e,t,i){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],p=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ab=new Tu,Au=class{constructor(e){this.manager=e!==void 0?e:Ab,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Au.DEFAULT_MATERIAL_NAME="__DEFAULT";var cc=class extends dn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new qe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},hc=class extends cc{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(dn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new qe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},qp=new St,Ly=new P,Dy=new P,Ru=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Se(512,512),this.mapType=Oi,this.map=null,this.mapPass=null,this.matrix=new St,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Jr,this._frameExtents=new Se(1,1),this._viewportCount=1,this._viewports=[new Bt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Ly.setFromMatrixPosition(e.matrixWorld),t.position.copy(Ly),Dy.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Dy),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){qp.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(qp,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===So||e.reversedDepth?t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),t.multiply(qp)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Hh=new P,Vh=new Ci,zs=new P,uc=class extends dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new St,this.projectionMatrix=new St,this.projectionMatrixInverse=new St,this.coordinateSystem=ls,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Hh,Vh,zs),zs.x===1&&zs.y===1&&zs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Hh,Vh,zs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Hh,Vh,zs),zs.x===1&&zs.y===1&&zs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Hh,Vh,zs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},jr=new P,Ny=new Se,Uy=new Se,En=class extends uc{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Eo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ll*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Eo*2*Math.atan(Math.tan(Ll*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){jr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(jr.x,jr.y).multiplyScalar(-e/jr.z),jr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(jr.x,jr.y).multiplyScalar(-e/jr.z)}getViewSize(e,t){return this.getViewBounds(e,Ny,Uy),t.subVectors(Uy,Ny)}setViewOffset(e,t,i,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ll*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*i/c,s*=a.width/l,i*=a.height/c}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Zi=class extends uc{constructor(e=-1,t=1,i=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,a=i+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},im=class extends Ru{constructor(){super(new Zi(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},fc=class extends cc{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(dn.DEFAULT_UP),this.updateMatrix(),this.target=new dn,this.shadow=new im}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var dc=class extends vt{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var vo=-90,yo=1,Do=class extends dn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new En(vo,yo,e,t);s.layers=this.layers,this.add(s);let r=new En(vo,yo,e,t);r.layers=this.layers,this.add(r);let a=new En(vo,yo,e,t);a.layers=this.layers,this.add(a);let o=new En(vo,yo,e,t);o.layers=this.layers,this.add(o);let l=new En(vo,yo,e,t);l.layers=this.layers,this.add(l);let c=new En(vo,yo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,a,o,l]=t;for(let c of t)this.remove(c);if(e===ls)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===So)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,u=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,f,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Cu=class extends En{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var km="\\[\\]\\.:\\/",qM=new RegExp("["+km+"]","g"),Bm="[^"+km+"]",YM="[^"+km.replace("\\.","")+"]",jM=/((?:WC+[\/:])*)/.source.replace("WC",Bm),ZM=/(WCOD+)?/.source.replace("WCOD",YM),JM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Bm),KM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Bm),QM=new RegExp("^"+jM+ZM+JM+KM+"$"),eE=["material","materials","bones","map"],sm=class{constructor(e,t,i){let s=i||on.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},on=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(qM,"")}static parseTrackName(e){let t=QM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);eE.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let l=i(o.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){rt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){rt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){rt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){rt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){rt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[s];if(a===void 0){let c=t.nodeName;rt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};on.Composite=sm;on.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};on.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};on.prototype.GetterByBindingType=[on.prototype._getValue_direct,on.prototype._getValue_array,on.prototype._getValue_arrayElement,on.prototype._getValue_toArray];on.prototype.SetterByBindingTypeAndVersioning=[[on.prototype._setValue_direct,on.prototype._setValue_direct_setNeedsUpdate,on.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[on.prototype._setValue_array,on.prototype._setValue_array_setNeedsUpdate,on.prototype._setValue_array_setMatrixWorldNeedsUpdate],[on.prototype._setValue_arrayElement,on.prototype._setValue_arrayElement_setNeedsUpdate,on.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[on.prototype._setValue_fromArray,on.prototype._setValue_fromArray_setNeedsUpdate,on.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var mN=new Float32Array(1);var na=class extends ru{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var Fy=new St,pc=class{constructor(e,t,i=0,s=1/0){this.ray=new br(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new Ao,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):rt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Fy.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Fy),this}intersectObject(e,t=!0,i=[]){return rm(e,this,i,t),i.sort(Oy),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)rm(e[s],this,i,t);return i.sort(Oy),i}};function Oy(n,e){return n.distance-e.distance}function rm(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let a=0,o=r.length;a<o;a++)rm(r[a],e,t,!0)}}var No=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ct(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ct(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var am=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var ky=new P,Gh=new P,bo=new P,xo=new P,Yp=new P,tE=new P,nE=new P,mc=class{constructor(e=new P,t=new P){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){ky.subVectors(e,this.start),Gh.subVectors(this.end,this.start);let i=Gh.dot(Gh);if(i===0)return 0;let r=Gh.dot(ky)/i;return t&&(r=ct(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=tE,i=nE){let s=10000000000000001e-32,r,a,o=this.start,l=e.start,c=this.end,h=e.end;bo.subVectors(c,o),xo.subVectors(h,l),Yp.subVectors(o,l);let u=bo.dot(bo),f=xo.dot(xo),d=xo.dot(Yp);if(u<=s&&f<=s)return t.copy(o),i.copy(l),t.distanceToSquared(i);if(u<=s)r=0,a=d/f,a=ct(a,0,1);else{let p=bo.dot(Yp);if(f<=s)a=0,r=ct(-p/u,0,1);else{let v=bo.dot(xo),m=u*f-v*v;m!==0?r=ct((v*d-p*f)/m,0,1):r=0,a=(v*r+d)/f,a<0?(a=0,r=ct(-p/u,0,1)):a>1&&(a=1,r=ct((v-p)/u,0,1))}}return t.copy(o).addScaledVector(bo,r),i.copy(l).addScaledVector(xo,a),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var gc=class extends _s{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function zm(n,e,t,i){let s=iE(i);switch(t){case Em:return n*e;case Ou:return n*e/s.components*s.byteLength;case ku:return n*e/s.components*s.byteLength;case ia:return n*e*2/s.components*s.byteLength;case Bu:return n*e*2/s.components*s.byteLength;case Tm:return n*e*3/s.components*s.byteLength;case As:return n*e*4/s.components*s.byteLength;case zu:return n*e*4/s.components*s.byteLength;case bc:case xc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case _c:case wc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Vu:case Wu:return Math.max(n,16)*Math.max(e,8)/4;case Hu:case Gu:return Math.max(n,8)*Math.max(e,8)/2;case Xu:case $u:case Yu:case ju:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case qu:case Sc:case Zu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ju:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ku:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Qu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case ef:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case tf:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case nf:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case sf:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case rf:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case af:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case of:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case lf:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case cf:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case hf:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case uf:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case ff:case df:case pf:return Math.ceil(n/4)*Math.ceil(e/4)*16;case mf:case gf:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Mc:case vf:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function iE(n){switch(n){case Oi:case _m:return{byteLength:1,components:1};case ko:case wm:case Ts:return{byteLength:2,components:1};case Uu:case Fu:return{byteLength:2,components:4};case Ji:case Nu:case hs:return{byteLength:4,components:1};case Sm:case Mm:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function jb(){let n=null,e=!1,t=null,i=null;function s(r,a){i=n.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function rE(n){let e=new WeakMap;function t(o,l){let c=o.array,h=o.usage,u=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,h),o.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:u}}function i(o,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,o),u.length===0)n.bufferSubData(c,0,h);else{u.sort((d,p)=>d.start-p.start);let f=0;for(let d=1;d<u.length;d++){let p=u[f],v=u[d];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++f,u[f]=v)}u.length=f+1;for(let d=0,p=u.length;d<p;d++){let v=u[d];n.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(n.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var aE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,oE=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,lE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,cE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,hE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,uE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,fE=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,dE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,pE=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,mE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,gE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,vE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,yE=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,bE=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,xE=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,_E=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,wE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,SE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ME=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,EE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,TE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,AE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,RE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,CE=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,PE=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,IE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,LE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,DE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,NE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,UE="gl_FragColor = linearToOutputTexel( gl_FragColor );",FE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,OE=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,kE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,BE=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,zE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,HE=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,VE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,GE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,WE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,XE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,$E=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,qE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,YE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,jE=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ZE=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,JE=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,KE=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,QE=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,eT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,tT=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,nT=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,iT=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,sT=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,rT=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,aT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,oT=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,lT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,cT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,hT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,uT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,fT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,dT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,pT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,mT=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,gT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,vT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,yT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,bT=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,xT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,_T=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,wT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ST=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,MT=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,ET=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,TT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,AT=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,RT=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,CT=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,PT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,IT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,LT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,DT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,NT=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,UT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,FT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,OT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,kT=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,BT=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,zT=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,HT=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,VT=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,GT=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,WT=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,XT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,$T=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,qT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,YT=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,jT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ZT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,JT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,KT=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,QT=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,eA=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,tA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,nA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,iA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,sA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,rA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,aA=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,oA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lA=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,hA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,uA=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,fA=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,dA=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,pA=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,mA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,gA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,vA=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,yA=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,bA=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,xA=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_A=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,wA=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,SA=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,MA=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,EA=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,TA=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,AA=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,RA=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,CA=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,PA=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,IA=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,LA=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,DA=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,NA=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,UA=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,FA=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,OA=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,kA=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,yt={alphahash_fragment:aE,alphahash_pars_fragment:oE,alphamap_fragment:lE,alphamap_pars_fragment:cE,alphatest_fragment:hE,alphatest_pars_fragment:uE,aomap_fragment:fE,aomap_pars_fragment:dE,batching_pars_vertex:pE,batching_vertex:mE,begin_vertex:gE,beginnormal_vertex:vE,bsdfs:yE,iridescence_fragment:bE,bumpmap_pars_fragment:xE,clipping_planes_fragment:_E,clipping_planes_pars_fragment:wE,clipping_planes_pars_vertex:SE,clipping_planes_vertex:ME,color_fragment:EE,color_pars_fragment:TE,color_pars_vertex:AE,color_vertex:RE,common:CE,defaultnormal_vertex:PE,displacementmap_pars_vertex:IE,displacementmap_vertex:LE,emissivemap_fragment:DE,emissivemap_pars_fragment:NE,colorspace_fragment:UE,colorspace_pars_fragment:FE,envmap_fragment:OE,envmap_common_pars_fragment:kE,envmap_pars_fragment:BE,envmap_pars_vertex:zE,envmap_physical_pars_fragment:JE,envmap_vertex:HE,fog_vertex:VE,fog_pars_vertex:GE,fog_fragment:WE,fog_pars_fragment:XE,gradientmap_pars_fragment:$E,lightmap_pars_fragment:qE,lights_lambert_fragment:YE,lights_lambert_pars_fragment:jE,lights_pars_begin:ZE,lights_toon_fragment:KE,lights_toon_pars_fragment:QE,lights_phong_fragment:eT,lights_phong_pars_fragment:tT,lights_physical_fragment:nT,lights_physical_pars_fragment:iT,lights_fragment_begin:sT,lights_fragment_maps:rT,lights_fragment_end:aT,lightprobes_pars_fragment:oT,logdepthbuf_fragment:lT,logdepthbuf_pars_fragment:cT,logdepthbuf_pars_vertex:hT,logdepthbuf_vertex:uT,map_fragment:fT,map_pars_fragment:dT,map_particle_fragment:pT,map_particle_pars_fragment:mT,metalnessmap_fragment:gT,metalnessmap_pars_fragment:vT,morphinstance_vertex:yT,morphcolor_vertex:bT,morphnormal_vertex:xT,morphtarget_pars_vertex:_T,morphtarget_vertex:wT,normal_fragment_begin:ST,normal_fragment_maps:MT,normal_pars_fragment:ET,normal_pars_vertex:TT,normal_vertex:AT,normalmap_pars_fragment:RT,clearcoat_normal_fragment_begin:CT,clearcoat_normal_fragment_maps:PT,clearcoat_pars_fragment:IT,iridescence_pars_fragment:LT,opaque_fragment:DT,packing:NT,premultiplied_alpha_fragment:UT,project_vertex:FT,dithering_fragment:OT,dithering_pars_fragment:kT,roughnessmap_fragment:BT,roughnessmap_pars_fragment:zT,shadowmap_pars_fragment:HT,shadowmap_pars_vertex:VT,shadowmap_vertex:GT,shadowmask_pars_fragment:WT,skinbase_vertex:XT,skinning_pars_vertex:$T,skinning_vertex:qT,skinnormal_vertex:YT,specularmap_fragment:jT,specularmap_pars_fragment:ZT,tonemapping_fragment:JT,tonemapping_pars_fragment:KT,transmission_fragment:QT,transmission_pars_fragment:eA,uv_pars_fragment:tA,uv_pars_vertex:nA,uv_vertex:iA,worldpos_vertex:sA,background_vert:rA,background_frag:aA,backgroundCube_vert:oA,backgroundCube_frag:lA,cube_vert:cA,cube_frag:hA,depth_vert:uA,depth_frag:fA,distance_vert:dA,distance_frag:pA,equirect_vert:mA,equirect_frag:gA,linedashed_vert:vA,linedashed_frag:yA,meshbasic_vert:bA,meshbasic_frag:xA,meshlambert_vert:_A,meshlambert_frag:wA,meshmatcap_vert:SA,meshmatcap_frag:MA,meshnormal_vert:EA,meshnormal_frag:TA,meshphong_vert:AA,meshphong_frag:RA,meshphysical_vert:CA,meshphysical_frag:PA,meshtoon_vert:IA,meshtoon_frag:LA,points_vert:DA,points_frag:NA,shadow_vert:UA,shadow_frag:FA,sprite_vert:OA,sprite_frag:kA},Le={common:{diffuse:{value:new qe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new Se(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new qe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new qe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new qe(16777215)},opacity:{value:1},center:{value:new Se(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},Ii={basic:{uniforms:yi([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:yt.meshbasic_vert,fragmentShader:yt.meshbasic_frag},lambert:{uniforms:yi([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new qe(0)},envMapIntensity:{value:1}}]),vertexShader:yt.meshlambert_vert,fragmentShader:yt.meshlambert_frag},phong:{uniforms:yi([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new qe(0)},specular:{value:new qe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:yt.meshphong_vert,fragmentShader:yt.meshphong_frag},standard:{uniforms:yi([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new qe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:yt.meshphysical_vert,fragmentShader:yt.meshphysical_frag},toon:{uniforms:yi([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new qe(0)}}]),vertexShader:yt.meshtoon_vert,fragmentShader:yt.meshtoon_frag},matcap:{uniforms:yi([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:yt.meshmatcap_vert,fragmentShader:yt.meshmatcap_frag},points:{uniforms:yi([Le.points,Le.fog]),vertexShader:yt.points_vert,fragmentShader:yt.points_frag},dashed:{uniforms:yi([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:yt.linedashed_vert,fragmentShader:yt.linedashed_frag},depth:{uniforms:yi([Le.common,Le.displacementmap]),vertexShader:yt.depth_vert,fragmentShader:yt.depth_frag},normal:{uniforms:yi([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:yt.meshnormal_vert,fragmentShader:yt.meshnormal_frag},sprite:{uniforms:yi([Le.sprite,Le.fog]),vertexShader:yt.sprite_vert,fragmentShader:yt.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:yt.background_vert,fragmentShader:yt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:yt.backgroundCube_vert,fragmentShader:yt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:yt.cube_vert,fragmentShader:yt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:yt.equirect_vert,fragmentShader:yt.equirect_frag},distance:{uniforms:yi([Le.common,Le.displacementmap,{referencePosition:{value:new P},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:yt.distance_vert,fragmentShader:yt.distance_frag},shadow:{uniforms:yi([Le.lights,Le.fog,{color:{value:new qe(0)},opacity:{value:1}}]),vertexShader:yt.shadow_vert,fragmentShader:yt.shadow_frag}};Ii.physical={uniforms:yi([Ii.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new Se(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new qe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new Se},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new qe(0)},specularColor:{value:new qe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new Se},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:yt.meshphysical_vert,fragmentShader:yt.meshphysical_frag};var xf={r:0,b:0,g:0},BA=new St,Zb=new nt;Zb.set(-1,0,0,0,1,0,0,0,1);function zA(n,e,t,i,s,r){let a=new qe(0),o=s===!0?0:1,l,c,h=null,u=0,f=null;function d(y){let _=y.isScene===!0?y.background:null;if(_&&_.isTexture){let x=y.backgroundBlurriness>0;_=e.get(_,x)}return _}function p(y){let _=!1,x=d(y);x===null?m(a,o):x&&x.isColor&&(m(x,1),_=!0);let T=n.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||_)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(y,_){let x=d(_);x&&x.isCubeTexture?(c===void 0&&(c=new zt(new Kr(1,1,1),new Fi({name:"BackgroundCubeMaterial",uniforms:Ta(Ii.backgroundCube.uniforms),vertexShader:Ii.backgroundCube.vertexShader,fragmentShader:Ii.backgroundCube.fragmentShader,side:Pi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,M,b){this.matrixWorld.copyPosition(b.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=x,c.material.uniforms.backgroundBlurriness.value=_.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(BA.makeRotationFromEuler(_.backgroundRotation)).transpose(),x.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Zb),c.material.toneMapped=Et.getTransfer(x.colorSpace)!==kt,(h!==x||u!==x.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,h=x,u=x.version,f=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):x&&x.isTexture&&(l===void 0&&(l=new zt(new rc(2,2),new Fi({name:"BackgroundMaterial",uniforms:Ta(Ii.background.uniforms),vertexShader:Ii.background.vertexShader,fragmentShader:Ii.background.fragmentShader,side:$s,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=x,l.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,l.material.toneMapped=Et.getTransfer(x.colorSpace)!==kt,x.matrixAutoUpdate===!0&&x.updateMatrix(),l.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||u!==x.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,h=x,u=x.version,f=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,_){y.getRGB(xf,Om(n)),t.buffers.color.setClear(xf.r,xf.g,xf.b,_,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(y,_=1){a.set(y),o=_,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(y){o=y,m(a,o)},render:p,addToRenderList:v,dispose:g}}function HA(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,a=!1;function o(L,O,z,U,G){let q=!1,H=u(L,U,z,O);r!==H&&(r=H,c(r.object)),q=d(L,U,z,G),q&&p(L,U,z,G),G!==null&&e.update(G,n.ELEMENT_ARRAY_BUFFER),(q||a)&&(a=!1,x(L,O,z,U),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function h(L){return n.deleteVertexArray(L)}function u(L,O,z,U){let G=U.wireframe===!0,q=i[O.id];q===void 0&&(q={},i[O.id]=q);let H=L.isInstancedMesh===!0?L.id:0,le=q[H];le===void 0&&(le={},q[H]=le);let j=le[z.id];j===void 0&&(j={},le[z.id]=j);let te=j[G];return te===void 0&&(te=f(l()),j[G]=te),te}function f(L){let O=[],z=[],U=[];for(let G=0;G<t;G++)O[G]=0,z[G]=0,U[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:z,attributeDivisors:U,object:L,attributes:{},index:null}}function d(L,O,z,U){let G=r.attributes,q=O.attributes,H=0,le=z.getAttributes();for(let j in le)if(le[j].location>=0){let ne=G[j],pe=q[j];if(pe===void 0&&(j==="instanceMatrix"&&L.instanceMatrix&&(pe=L.instanceMatrix),j==="instanceColor"&&L.instanceColor&&(pe=L.instanceColor)),ne===void 0||ne.attribute!==pe||pe&&ne.data!==pe.data)return!0;H++}return r.attributesNum!==H||r.index!==U}function p(L,O,z,U){let G={},q=O.attributes,H=0,le=z.getAttributes();for(let j in le)if(le[j].location>=0){let ne=q[j];ne===void 0&&(j==="instanceMatrix"&&L.instanceMatrix&&(ne=L.instanceMatrix),j==="instanceColor"&&L.instanceColor&&(ne=L.instanceColor));let pe={};pe.attribute=ne,ne&&ne.data&&(pe.data=ne.data),G[j]=pe,H++}r.attributes=G,r.attributesNum=H,r.index=U}function v(){let L=r.newAttributes;for(let O=0,z=L.length;O<z;O++)L[O]=0}function m(L){g(L,0)}function g(L,O){let z=r.newAttributes,U=r.enabledAttributes,G=r.attributeDivisors;z[L]=1,U[L]===0&&(n.enableVertexAttribArray(L),U[L]=1),G[L]!==O&&(n.vertexAttribDivisor(L,O),G[L]=O)}function y(){let L=r.newAttributes,O=r.enabledAttributes;for(let z=0,U=O.length;z<U;z++)O[z]!==L[z]&&(n.disableVertexAttribArray(z),O[z]=0)}function _(L,O,z,U,G,q,H){H===!0?n.vertexAttribIPointer(L,O,z,G,q):n.vertexAttribPointer(L,O,z,U,G,q)}function x(L,O,z,U){v();let G=U.attributes,q=z.getAttributes(),H=O.defaultAttributeValues;for(let le in q){let j=q[le];if(j.location>=0){let te=G[le];if(te===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(te=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(te=L.instanceColor)),te!==void 0){let ne=te.normalized,pe=te.itemSize,he=e.get(te);if(he===void 0)continue;let Q=he.buffer,fe=he.type,ve=he.bytesPerElement,Ee=fe===n.INT||fe===n.UNSIGNED_INT||te.gpuType===Nu;if(te.isInterleavedBufferAttribute){let be=te.data,Xe=be.isInterleavedBuffer===!0?be.stride:be.itemSize,ot=te.offset;if(be.isInstancedInterleavedBuffer||be.isInstancedBufferAttribute){for(let Ge=0;Ge<j.locationSize;Ge++)g(j.location+Ge,be.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=be.meshPerAttribute*be.count)}else for(let Ge=0;Ge<j.locationSize;Ge++)m(j.location+Ge);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Ge=0;Ge<j.locationSize;Ge++)_(j.location+Ge,pe/j.locationSize,fe,ne,Xe*ve,(ot+pe/j.locationSize*Ge)*ve,Ee)}else{if(te.isInstancedBufferAttribute){for(let be=0;be<j.locationSize;be++)g(j.location+be,te.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=te.meshPerAttribute*te.count)}else for(let be=0;be<j.locationSize;be++)m(j.location+be);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let be=0;be<j.locationSize;be++)_(j.location+be,pe/j.locationSize,fe,ne,pe*ve,pe/j.locationSize*be*ve,Ee)}}else if(H!==void 0){let ne=H[le];if(ne!==void 0)switch(ne.length){case 2:n.vertexAttrib2fv(j.location,ne);break;case 3:n.vertexAttrib3fv(j.location,ne);break;case 4:n.vertexAttrib4fv(j.location,ne);break;default:n.vertexAttrib1fv(j.location,ne)}}}}y()}function T(){C();for(let L in i){let O=i[L];for(let z in O){let U=O[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete i[L]}}function M(L){if(i[L.id]===void 0)return;let O=i[L.id];for(let z in O){let U=O[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete i[L.id]}function b(L){for(let O in i){let z=i[O];for(let U in z){let G=z[U];if(G[L.id]===void 0)continue;let q=G[L.id];for(let H in q)h(q[H].object),delete q[H];delete G[L.id]}}}function S(L){for(let O in i){let z=i[O],U=L.isInstancedMesh===!0?L.id:0,G=z[U];if(G!==void 0){for(let q in G){let H=G[q];for(let le in H)h(H[le].object),delete H[le];delete G[q]}delete z[U],Object.keys(z).length===0&&delete i[O]}}}function C(){I(),a=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:C,resetDefaultState:I,dispose:T,releaseStatesOfGeometry:M,releaseStatesOfObject:S,releaseStatesOfProgram:b,initAttributes:v,enableAttribute:m,disableUnusedAttributes:y}}function VA(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function a(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function o(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function GA(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let b=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(b.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(b){return!(b!==As&&i.convert(b)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(b){let S=b===Ts&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(b!==Oi&&b!==hs&&!S&&i.convert(b)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(b){if(b==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";b="mediump"}return b==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Je("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),_=n.getParameter(n.MAX_VARYING_VECTORS),x=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:_,maxFragmentUniforms:x,maxSamples:T,samples:M}}function WA(n){let e=this,t=null,i=0,s=!1,r=!1,a=new Ai,o=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||i!==0||s;return s=f,i=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){t=h(u,f,0)},this.setState=function(u,f,d){let p=u.clippingPlanes,v=u.clipIntersection,m=u.clipShadows,g=n.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let y=r?0:i,_=y*4,x=g.clippingState||null;l.value=x,x=h(p,f,_,d);for(let T=0;T!==_;++T)x[T]=t[T];g.clippingState=x,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(u,f,d,p){let v=u!==null?u.length:0,m=null;if(v!==0){if(m=l.value,p!==!0||m===null){let g=d+v*4,y=f.matrixWorldInverse;o.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let _=0,x=d;_!==v;++_,x+=4)a.copy(u[_]).applyMatrix4(y,o),a.normal.toArray(m,x),m[x+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,m}}var Cc=class extends ai{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new $l(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Kr(5,5,5),r=new Fi({name:"CubemapFromEquirect",uniforms:Ta(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Pi,blending:Mr});r.uniforms.tEquirect.value=t;let a=new zt(s,r),o=t.minFilter;return t.minFilter===Er&&(t.minFilter=Ri),new Do(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,i,s);e.setRenderTarget(r)}},Rb=256,XA=3,$A=20,Jb=256,Kb=16,qA=3,YA=new P,jA=new qe,wf=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Do(1,10,null),this._boxMesh=new zt(new Kr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:a=256,position:o=YA}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(jA));let m=new Do(i,s,h);return m.position.copy(o),m.update(l,e),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=p,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ib(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Pb(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Rb,Dm(e))}_fromTexture(e,t){e.mapping===Ma||e.mapping===Oo?this._setSize(e.image.length===0?Rb:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Cb(e,!1,!1),i=Math.log2(e)-XA;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Cb(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ma||e.mapping===Oo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ib()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Pb()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=ZA(),this._integrationMaterial=JA());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Kb);for(let a=0;a<=i;a++){let o=n.lodToRoughness(a,i);if(a>i-qA)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(Jb*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=KA());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Cb(n,e,t){return new Cc(n,{minFilter:Er,generateMipmaps:e,type:Ts,colorSpace:Ol,depthBuffer:t})}function Pc(n,e,t){return new Fi({name:n,uniforms:e,vertexShader:yt.cube_vert,fragmentShader:t,side:Pi,blending:Mr,depthTest:!1,depthWrite:!1})}function ZA(){return Pc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Jb}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function JA(){return Pc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Kb}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function KA(){return Pc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${$A}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Pb(){return Pc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Ib(){return Pc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function QA(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?a(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Iu||d===Lu)if(e.has(f)){let p=e.get(f).texture;return o(p,f.mapping)}else{let p=f.image;if(p&&p.height>0){let v=new Cc(p.height);return v.fromEquirectangularTexture(n,f),e.set(f,v),f.addEventListener("dispose",c),o(v.texture,f.mapping)}else return null}}return f}function a(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,p=d===Iu||d===Lu,v=d===Ma||d===Oo;if(p||v){let m=t.get(f),g=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return i===null&&(i=new wf(n)),m=p?i.fromEquirectangular(f,m):i.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),m.texture;if(m!==void 0)return m.texture;{let y=f.image;return p&&y&&y.height>0||v&&y&&l(y)?(i===null&&(i=new wf(n)),m=p?i.fromEquirectangular(f):i.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),f.addEventListener("dispose",h),m.texture):null}}}return f}function o(f,d){return d===Iu?f.mapping=Ma:d===Lu&&(f.mapping=Oo),f}function l(f){let d=0,p=6;for(let v=0;v<p;v++)f[v]!==void 0&&d++;return d===p}function c(f){let d=f.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function e2(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Il("WebGLRenderer: "+i+" extension not supported."),s}}}function t2(n,e,t,i){let s={},r=new WeakMap,a=new FinalizationRegistry(p=>delete s[p]);function o(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",o),delete s[p.id],a.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",o),s[v.id]=new WeakRef(v),a.register(v,v.id,v),t.memory.geometries++),v}function h(p){let v=p.attributes;for(let m in v)e.update(v[m],n.ARRAY_BUFFER)}function u(p){let v=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let y=v!==null?v.array.length:m.array.length/3-1,_=m.count>=65535?Wl:Gl,x=new _(Math.ceil(y/3)*6,1),T=x.array;if(v!==null){let b=v.array;g=v.version;for(let S=0,C=0;S<y;S+=3){let I=b[S+0],L=b[S+1],O=b[S+2];T[C++]=I,T[C++]=L,T[C++]=L,T[C++]=O,T[C++]=O,T[C++]=I}}else{g=m.version;for(let b=0,S=0;b<y;b+=3){let C=b+0,I=b+1,L=b+2;T[S++]=C,T[S++]=I,T[S++]=I,T[S++]=L,T[S++]=L,T[S++]=C}}x.version=g;let M=r.get(p);M&&e.remove(M),r.set(p,x)}function f(p){let v=r.get(p);if(v){let m=p.index;m!==null&&v.version<m.version&&u(p)}else u(p);return r.get(p)}function d(){for(let p in s){let v=s[p].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function n2(n,e,t){let i;function s(u){i=u}let r,a;function o(u){r=u.type,a=u.bytesPerElement}function l(u,f){n.drawElements(i,f,r,u*a),t.update(f,i,1)}function c(u,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,u*a,d),t.update(f,i,d))}function h(u,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,u,0,d);let v=0;for(let m=0;m<d;m++)v+=f[m];t.update(v,i,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function i2(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,a,o){switch(t.calls++,a){case n.TRIANGLES:t.triangles+=o*(r/3);break;case n.LINES:t.lines+=o*(r/2);break;case n.LINE_STRIP:t.lines+=o*(r-1);break;case n.LINE_LOOP:t.lines+=o*r;break;case n.POINTS:t.points+=o*r;break;default:rt("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function s2(n,e,t){let i=new WeakMap,s=new Bt;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=h!==void 0?h.length:0,f=i.get(o);if(f===void 0||f.count!==u){let C=function(){b.dispose(),i.delete(o),o.removeEventListener("dispose",C)};f!==void 0&&f.texture.dispose();let d=o.morphAttributes.position!==void 0,p=o.morphAttributes.normal!==void 0,v=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],g=o.morphAttributes.normal||[],y=o.morphAttributes.color||[],_=0;d===!0&&(_=1),p===!0&&(_=2),v===!0&&(_=3);let x=o.attributes.position.count*_,T=1;x>e.maxTextureSize&&(T=Math.ceil(x/e.maxTextureSize),x=e.maxTextureSize);let M=new Float32Array(x*T*4*u),b=new Hl(M,x,T,u);b.type=hs,b.needsUpdate=!0;let S=_*4;for(let I=0;I<u;I++){let L=m[I],O=g[I],z=y[I],U=x*T*4*I;for(let G=0;G<L.count;G++){let q=G*S;d===!0&&(s.fromBufferAttribute(L,G),M[U+q+0]=s.x,M[U+q+1]=s.y,M[U+q+2]=s.z,M[U+q+3]=0),p===!0&&(s.fromBufferAttribute(O,G),M[U+q+4]=s.x,M[U+q+5]=s.y,M[U+q+6]=s.z,M[U+q+7]=0),v===!0&&(s.fromBufferAttribute(z,G),M[U+q+8]=s.x,M[U+q+9]=s.y,M[U+q+10]=s.z,M[U+q+11]=z.itemSize===4?s.w:1)}}f={count:u,texture:b,size:new Se(x,T)},i.set(o,f),o.addEventListener("dispose",C)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",a.morphTexture,t);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];let p=o.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function r2(n,e,t,i,s){let r=new WeakMap;function a(c){let h=s.render.frame,u=c.geometry,f=e.get(c,u);if(r.get(f)!==h&&(e.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}var a2={[dm]:"LINEAR_TONE_MAPPING",[pm]:"REINHARD_TONE_MAPPING",[mm]:"CINEON_TONE_MAPPING",[gm]:"ACES_FILMIC_TONE_MAPPING",[ym]:"AGX_TONE_MAPPING",[bm]:"NEUTRAL_TONE_MAPPING",[vm]:"CUSTOM_TONE_MAPPING"};function o2(n,e,t,i,s,r){let a=new ai(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new vt;h.setAttribute("position",new tt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new tt([0,2,0,0,2,0],2));let u=new mu({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new zt(h,u),d=new Zi(-1,1,1,-1,0,1),p=null,v=null,m=!1,g,y=null,_=[],x=!1;this.setSize=function(T,M){a.setSize(T,M),o!==null&&o.setSize(T,M),l!==null&&l.setSize(T,M);for(let b=0;b<_.length;b++){let S=_[b];S.setSize&&S.setSize(T,M)}},this.setEffects=function(T){_=T,x=_.length>0&&_[0].isRenderPass===!0;let M=a.width,b=a.height;_.length>0&&o===null&&(o=new ai(M,b,{type:Ts,depthBuffer:!1,stencilBuffer:!1}),l=new ai(M,b,{type:Ts,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&_.some(C=>C.needsDepthTexture===!0);S!==(a.depthTexture!==null)&&(S===!0&&c===null&&(c=new Ms(M,b),r===!0&&(c.format=Tr,c.type=Ea)),a.dispose(),a.depthTexture=S?c:null,a.resolveDepthBuffer=S,a.storeMultisampledDepthBuffer=S);for(let C=0;C<_.length;C++){let I=_[C];I.setSize&&I.setSize(M,b),S&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(T,M){if(m||T.toneMapping===qs&&_.length===0)return!1;if(y=M,M!==null){let b=M.width,S=M.height;(a.width!==b||a.height!==S)&&this.setSize(b,S)}return x===!1&&T.setRenderTarget(a),g=T.toneMapping,T.toneMapping=qs,!0},this.hasRenderPass=function(){return x},this.end=function(T,M){T.toneMapping=g,m=!0;let b=a,S=o;for(let C=0;C<_.length;C++){let I=_[C];I.enabled!==!1&&(I.render(T,S,b,M),I.needsSwap!==!1&&(b=S,S=S===o?l:o))}if(p!==T.outputColorSpace||v!==T.toneMapping){p=T.outputColorSpace,v=T.toneMapping,u.defines={},Et.getTransfer(p)===kt&&(u.defines.SRGB_TRANSFER="");let C=a2[v];C&&(u.defines[C]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=b.texture,T.setRenderTarget(y),T.render(f,d),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Qb=new Ni,ex=new Ms(1,1),tx=new ql(1),nx=new Hl,ix=new su,sx=new $l,Lb=[],Db=[],Nb=new Float32Array(16),Ub=new Float32Array(9),Fb=new Float32Array(4);function zo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Lb[s];if(r===void 0&&(r=new Float32Array(s),Lb[s]=r),e!==0){i.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,n[a].toArray(r,o)}return r}function Bn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function zn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Mf(n,e){let t=Db[e];t===void 0&&(t=new Int32Array(e),Db[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function l2(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function c2(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Bn(t,e))return;n.uniform2fv(this.addr,e),zn(t,e)}}function h2(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Bn(t,e))return;n.uniform3fv(this.addr,e),zn(t,e)}}function u2(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Bn(t,e))return;n.uniform4fv(this.addr,e),zn(t,e)}}function f2(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Bn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),zn(t,e)}else{if(Bn(t,i))return;Fb.set(i),n.uniformMatrix2fv(this.addr,!1,Fb),zn(t,i)}}function d2(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Bn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),zn(t,e)}else{if(Bn(t,i))return;Ub.set(i),n.uniformMatrix3fv(this.addr,!1,Ub),zn(t,i)}}function p2(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Bn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),zn(t,e)}else{if(Bn(t,i))return;Nb.set(i),n.uniformMatrix4fv(this.addr,!1,Nb),zn(t,i)}}function m2(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function g2(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Bn(t,e))return;n.uniform2iv(this.addr,e),zn(t,e)}}function v2(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Bn(t,e))return;n.uniform3iv(this.addr,e),zn(t,e)}}function y2(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Bn(t,e))return;n.uniform4iv(this.addr,e),zn(t,e)}}function b2(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function x2(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Bn(t,e))return;n.uniform2uiv(this.addr,e),zn(t,e)}}function _2(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Bn(t,e))return;n.uniform3uiv(this.addr,e),zn(t,e)}}function w2(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Bn(t,e))return;n.uniform4uiv(this.addr,e),zn(t,e)}}function Ef(n){return n.version===0&&(n.compareFunction=Cm,n.needsUpdate=!0),n}function S2(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Ef(ex):r=Qb,t.setTexture2D(e||r,s)}function M2(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||ix,s)}function E2(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Ef(tx):r=sx,t.setTextureCube(e||r,s)}function T2(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||nx,s)}function A2(n){switch(n){case 5126:return l2;case 35664:return c2;case 35665:return h2;case 35666:return u2;case 35674:return f2;case 35675:return d2;case 35676:return p2;case 5124:case 35670:return m2;case 35667:case 35671:return g2;case 35668:case 35672:return v2;case 35669:case 35673:return y2;case 5125:return b2;case 36294:return x2;case 36295:return _2;case 36296:return w2;case 35678:case 36198:case 36298:case 36306:case 35682:return S2;case 35679:case 36299:case 36307:return M2;case 35680:case 36300:case 36308:case 36293:return E2;case 36289:case 36303:case 36311:case 36292:return T2}}function R2(n,e){n.uniform1fv(this.addr,e)}function C2(n,e){let t=zo(e,this.size,2);n.uniform2fv(this.addr,t)}function P2(n,e){let t=zo(e,this.size,3);n.uniform3fv(this.addr,t)}function I2(n,e){let t=zo(e,this.size,4);n.uniform4fv(this.addr,t)}function L2(n,e){let t=zo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function D2(n,e){let t=zo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function N2(n,e){let t=zo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function U2(n,e){n.uniform1iv(this.addr,e)}function F2(n,e){n.uniform2iv(this.addr,e)}function O2(n,e){n.uniform3iv(this.addr,e)}function k2(n,e){n.uniform4iv(this.addr,e)}function B2(n,e){n.uniform1uiv(this.addr,e)}function z2(n,e){n.uniform2uiv(this.addr,e)}function H2(n,e){n.uniform3uiv(this.addr,e)}function V2(n,e){n.uniform4uiv(this.addr,e)}function G2(n,e,t){let i=this.cache,s=e.length,r=Mf(t,s);Bn(i,r)||(n.uniform1iv(this.addr,r),zn(i,r));let a;this.type===n.SAMPLER_2D_SHADOW?a=Ef(ex):a=Qb;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function W2(n,e,t){let i=this.cache,s=e.length,r=Mf(t,s);Bn(i,r)||(n.uniform1iv(this.addr,r),zn(i,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||ix,r[a])}function X2(n,e,t){let i=this.cache,s=e.length,r=Mf(t,s);Bn(i,r)||(n.uniform1iv(this.addr,r),zn(i,r));let a;this.type===n.SAMPLER_CUBE_SHADOW?a=Ef(tx):a=sx;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function $2(n,e,t){let i=this.cache,s=e.length,r=Mf(t,s);Bn(i,r)||(n.uniform1iv(this.addr,r),zn(i,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||nx,r[a])}function q2(n){switch(n){case 5126:return R2;case 35664:return C2;case 35665:return P2;case 35666:return I2;case 35674:return L2;case 35675:return D2;case 35676:return N2;case 5124:case 35670:return U2;case 35667:case 35671:return F2;case 35668:case 35672:return O2;case 35669:case 35673:return k2;case 5125:return B2;case 36294:return z2;case 36295:return H2;case 36296:return V2;case 35678:case 36198:case 36298:case 36306:case 35682:return G2;case 35679:case 36299:case 36307:return W2;case 35680:case 36300:case 36308:case 36293:return X2;case 36289:case 36303:case 36311:case 36292:return $2}}var Gm=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=A2(t.type)}},Wm=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=q2(t.type)}},Xm=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],i)}}},Hm=/(\w+)(\])?(\[|\.)?/g;function Ob(n,e){n.seq.push(e),n.map[e.id]=e}function Y2(n,e,t){let i=n.name,s=i.length;for(Hm.lastIndex=0;;){let r=Hm.exec(i),a=Hm.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Ob(t,c===void 0?new Gm(o,n,e):new Wm(o,n,e));break}else{let u=t.map[o];u===void 0&&(u=new Xm(o),Ob(t,u)),t=u}}}var Bo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<i;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);Y2(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],l=i[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&i.push(a)}return i}};function kb(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var j2=37297,Z2=0;function J2(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;i.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return i.join(`
`)}var Bb=new nt;function K2(n){Et._getMatrix(Bb,Et.workingColorSpace,n);let e=`mat3( ${Bb.elements.map(t=>t.toFixed(4))} )`;switch(Et.getTransfer(n)){case kl:return[e,"LinearTransferOETF"];case kt:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function zb(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+J2(n.getShaderSource(e),o)}else return r}function Q2(n,e){let t=K2(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var e3={[dm]:"Linear",[pm]:"Reinhard",[mm]:"Cineon",[gm]:"ACESFilmic",[ym]:"AgX",[bm]:"Neutral",[vm]:"Custom"};function t3(n,e){let t=e3[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var _f=new P;function n3(){Et.getLuminanceCoefficients(_f);let n=_f.x.toFixed(4),e=_f.y.toFixed(4),t=_f.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function i3(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Rc).join(`
`)}function s3(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function r3(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),a=r.name,o=1;r.type===n.FLOAT_MAT2&&(o=2),r.type===n.FLOAT_MAT3&&(o=3),r.type===n.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:n.getAttribLocation(e,a),locationSize:o}}return t}function Rc(n){return n!==""}function Hb(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Vb(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var a3=/^[ \t]*#include +<([\w\d./]+)>/gm;function $m(n){return n.replace(a3,o3)}function o3(n,e){let t=yt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return $m(t)}var l3=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Gb(n){return n.replace(l3,c3)}function c3(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Wb(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var h3={[vc]:"SHADOWMAP_TYPE_PCF",[Uo]:"SHADOWMAP_TYPE_VSM"};function u3(n){return h3[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var f3={[Oo]:"ENVMAP_MODE_REFRACTION"};function d3(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":f3[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var p3={[Pu]:"ENVMAP_BLENDING_MULTIPLY",[ab]:"ENVMAP_BLENDING_MIX",[ob]:"ENVMAP_BLENDING_ADD"};function m3(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":p3[n.combine]||"ENVMAP_BLENDING_NONE"}function g3(n,e,t,i){let s=n.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,l=u3(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=d3(t),u=m3(t),f=i3(t),d=s3(r),p=s.createProgram(),v,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Rc).join(`
`),v.length>0&&(v+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Rc).join(`
`),m.length>0&&(m+=`
`)):(v=[Wb(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Rc).join(`
`),m=[Wb(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==qs?"#define TONE_MAPPING":"",t.toneMapping!==qs?yt.tonemapping_pars_fragment:"",t.toneMapping!==qs?t3("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",yt.colorspace_pars_fragment,Q2("linearToOutputTexel",t.outputColorSpace),n3(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Rc).join(`
`)),a=$m(a),a=Hb(a,t),a=Vb(a,t),o=$m(o),o=Hb(o,t),o=Vb(o,t),a=Gb(a),o=Gb(o),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,v=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,m=["#define varying in",t.glslVersion===Im?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Im?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+v+a,_=g+m+o,x=kb(s,s.VERTEX_SHADER,y),T=kb(s,s.FRAGMENT_SHADER,_);s.attachShader(p,x),s.attachShader(p,T),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(I){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(x)||"",z=s.getShaderInfoLog(T)||"",U=L.trim(),G=O.trim(),q=z.trim(),H=!0,le=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,x,T);else{let j=zb(s,x,"vertex"),te=zb(s,T,"fragment");rt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+U+`
`+j+`
`+te)}else U!==""?Je("WebGLProgram: Program Info Log:",U):(G===""||q==="")&&(le=!1);le&&(I.diagnostics={runnable:H,programLog:U,vertexShader:{log:G,prefix:v},fragmentShader:{log:q,prefix:m}})}s.deleteShader(x),s.deleteShader(T),b=new Bo(s,p),S=r3(s,p)}let b;this.getUniforms=function(){return b===void 0&&M(this),b};let S;this.getAttributes=function(){return S===void 0&&M(this),S};let C=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return C===!1&&(C=s.getProgramParameter(p,j2)),C},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Z2++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=x,this.fragmentShader=T,this}var v3=0,qm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Ym(e),t.set(e,i)),i}},Ym=class{constructor(e){this.id=v3++,this.code=e,this.usedTimes=0}};function y3(n){return n===ia||n===Sc||n===Mc}function b3(n,e,t,i,s,r){let a=new Ao,o=new qm,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(b){return l.add(b),b===0?"uv":`uv${b}`}function p(b,S,C,I,L,O){let z=I.fog,U=L.geometry,G=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?I.environment:null,q=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap,H=e.get(b.envMap||G,q),le=f[b.type],j=i.precision;b.precision!==null&&(j=i.getMaxPrecision(b.precision),j!==b.precision&&Je("WebGLProgram.getParameters:",b.precision,"not supported, using",j,"instead."));let te=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,ne=te!==void 0?te.length:0,pe=0;U.morphAttributes.position!==void 0&&(pe=1),U.morphAttributes.normal!==void 0&&(pe=2),U.morphAttributes.color!==void 0&&(pe=3);let he,Q,fe,ve;if(le){let Pe=Ii[le];he=Pe.vertexShader,Q=Pe.fragmentShader}else{he=b.vertexShader,Q=b.fragmentShader;let Pe=o.getVertexShaderStage(b),pt=o.getFragmentShaderStage(b);o.update(b,Pe,pt),fe=Pe.id,ve=pt.id}let Ee=n.getRenderTarget(),be=n.state.buffers.depth.getReversed(),Xe=L.isInstancedMesh===!0,ot=L.isBatchedMesh===!0,Ge=!!b.map,dt=!!b.matcap,ut=!!H,Qe=ut&&H.isPMREMTexture===!0,un=!!b.aoMap,Qt=!!b.lightMap,Tn=!!b.bumpMap&&b.wireframe===!1,Xt=!!b.normalMap,Xn=!!b.displacementMap,Rt=!!b.emissiveMap,Fn=!!b.metalnessMap,yn=!!b.roughnessMap,An=b.anisotropy>0,B=b.clearcoat>0,Ie=b.diffuseRoughness>0,Ke=b.dispersion>0,ft=b.retroreflectivity>0,Te=b.iridescence>0,Yt=b.sheen>0,We=b.transmission>0,Ze=An&&!!b.anisotropyMap,D=B&&!!b.clearcoatMap,E=B&&!!b.clearcoatNormalMap,$=B&&!!b.clearcoatRoughnessMap,de=Ie&&!!b.diffuseRoughnessMap,oe=Te&&!!b.iridescenceMap,xe=Te&&!!b.iridescenceThicknessMap,_e=Yt&&!!b.sheenColorMap,ie=Yt&&!!b.sheenRoughnessMap,re=!!b.specularMap,ge=!!b.specularColorMap,k=!!b.specularIntensityMap,ae=We&&!!b.transmissionMap,se=We&&!!b.thicknessMap,Ae=!!b.gradientMap,ye=!!b.alphaMap,Me=b.alphaTest>0,$e=!!b.alphaHash,it=!!b.extensions,ue=qs;b.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(ue=n.toneMapping);let ze=Qe?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,st={shaderID:le,shaderType:b.type,shaderName:b.name,vertexShader:he,fragmentShader:Q,defines:b.defines,customVertexShaderID:fe,customFragmentShaderID:ve,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:j,batching:ot,batchingColor:ot&&L._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&L.instanceColor!==null,instancingMorph:Xe&&L.morphTexture!==null,outputColorSpace:Ee===null?n.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:Et.workingColorSpace,alphaToCoverage:!!b.alphaToCoverage,map:Ge,matcap:dt,envMap:ut,envMapMode:ut&&H.mapping,envMapPMREM:Qe,envMapMaxLod:Qe?ze.length-1:null,envMapSize:Qe?ze[0].width:null,aoMap:un,lightMap:Qt,bumpMap:Tn,normalMap:Xt,displacementMap:Xn,emissiveMap:Rt,normalMapObjectSpace:Xt&&b.normalMapType===hb,normalMapTangentSpace:Xt&&b.normalMapType===yf,packedNormalMap:Xt&&b.normalMapType===yf&&y3(b.normalMap.format),metalnessMap:Fn,roughnessMap:yn,anisotropy:An,anisotropyMap:Ze,clearcoat:B,clearcoatMap:D,clearcoatNormalMap:E,clearcoatRoughnessMap:$,diffuseRoughness:Ie,diffuseRoughnessMap:de,dispersion:Ke,retroreflection:ft,iridescence:Te,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:Yt,sheenColorMap:_e,sheenRoughnessMap:ie,specularMap:re,specularColorMap:ge,specularIntensityMap:k,transmission:We,transmissionMap:ae,thicknessMap:se,gradientMap:Ae,opaque:b.transparent===!1&&b.blending===Fo&&b.alphaToCoverage===!1,alphaMap:ye,alphaTest:Me,alphaHash:$e,combine:b.combine,mapUv:Ge&&d(b.map.channel),aoMapUv:un&&d(b.aoMap.channel),lightMapUv:Qt&&d(b.lightMap.channel),bumpMapUv:Tn&&d(b.bumpMap.channel),normalMapUv:Xt&&d(b.normalMap.channel),displacementMapUv:Xn&&d(b.displacementMap.channel),emissiveMapUv:Rt&&d(b.emissiveMap.channel),metalnessMapUv:Fn&&d(b.metalnessMap.channel),roughnessMapUv:yn&&d(b.roughnessMap.channel),anisotropyMapUv:Ze&&d(b.anisotropyMap.channel),clearcoatMapUv:D&&d(b.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&d(b.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&d(b.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(b.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&d(b.iridescenceThicknessMap.channel),sheenColorMapUv:_e&&d(b.sheenColorMap.channel),sheenRoughnessMapUv:ie&&d(b.sheenRoughnessMap.channel),specularMapUv:re&&d(b.specularMap.channel),specularColorMapUv:ge&&d(b.specularColorMap.channel),specularIntensityMapUv:k&&d(b.specularIntensityMap.channel),transmissionMapUv:ae&&d(b.transmissionMap.channel),thicknessMapUv:se&&d(b.thicknessMap.channel),alphaMapUv:ye&&d(b.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Xt||An),vertexNormals:!!U.attributes.normal,vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!U.attributes.uv&&(Ge||ye),fog:!!z,useFog:b.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:b.wireframe===!1&&(b.flatShading===!0||U.attributes.normal===void 0&&Xt===!1&&(b.isMeshLambertMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isMeshPhysicalMaterial)),sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:be,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:pe,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:O.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:b.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:ue,decodeVideoTexture:Ge&&b.map.isVideoTexture===!0&&Et.getTransfer(b.map.colorSpace)===kt,decodeVideoTextureEmissive:Rt&&b.emissiveMap.isVideoTexture===!0&&Et.getTransfer(b.emissiveMap.colorSpace)===kt,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===vn,flipSided:b.side===Pi,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:it&&b.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(it&&b.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return st.vertexUv1s=l.has(1),st.vertexUv2s=l.has(2),st.vertexUv3s=l.has(3),l.clear(),st}function v(b){let S=[];if(b.shaderID?S.push(b.shaderID):(S.push(b.customVertexShaderID),S.push(b.customFragmentShaderID)),b.defines!==void 0)for(let C in b.defines)S.push(C),S.push(b.defines[C]);return b.isRawShaderMaterial===!1&&(m(S,b),g(S,b),S.push(n.outputColorSpace)),S.push(b.customProgramCacheKey),S.join()}function m(b,S){b.push(S.precision),b.push(S.outputColorSpace),b.push(S.envMapMode),b.push(S.envMapPMREM),b.push(S.envMapMaxLod),b.push(S.envMapSize),b.push(S.mapUv),b.push(S.alphaMapUv),b.push(S.lightMapUv),b.push(S.aoMapUv),b.push(S.bumpMapUv),b.push(S.normalMapUv),b.push(S.displacementMapUv),b.push(S.emissiveMapUv),b.push(S.metalnessMapUv),b.push(S.roughnessMapUv),b.push(S.anisotropyMapUv),b.push(S.clearcoatMapUv),b.push(S.clearcoatNormalMapUv),b.push(S.clearcoatRoughnessMapUv),b.push(S.diffuseRoughnessMapUv),b.push(S.iridescenceMapUv),b.push(S.iridescenceThicknessMapUv),b.push(S.sheenColorMapUv),b.push(S.sheenRoughnessMapUv),b.push(S.specularMapUv),b.push(S.specularColorMapUv),b.push(S.specularIntensityMapUv),b.push(S.transmissionMapUv),b.push(S.thicknessMapUv),b.push(S.combine),b.push(S.fogExp2),b.push(S.sizeAttenuation),b.push(S.morphTargetsCount),b.push(S.numSunLights),b.push(S.numDirLights),b.push(S.numPointLights),b.push(S.numSpotLights),b.push(S.numSpotLightMaps),b.push(S.numHemiLights),b.push(S.numRectAreaLights),b.push(S.numSunLightShadows),b.push(S.numDirLightShadows),b.push(S.numPointLightShadows),b.push(S.numSpotLightShadows),b.push(S.numSpotLightShadowsWithMaps),b.push(S.numLightProbes),b.push(S.numLightProbeGrids),b.push(S.shadowMapType),b.push(S.toneMapping),b.push(S.numClippingPlanes),b.push(S.numClipIntersection),b.push(S.depthPacking)}function g(b,S){a.disableAll(),S.instancing&&a.enable(0),S.instancingColor&&a.enable(1),S.instancingMorph&&a.enable(2),S.matcap&&a.enable(3),S.envMap&&a.enable(4),S.normalMapObjectSpace&&a.enable(5),S.normalMapTangentSpace&&a.enable(6),S.clearcoat&&a.enable(7),S.iridescence&&a.enable(8),S.alphaTest&&a.enable(9),S.vertexColors&&a.enable(10),S.vertexAlphas&&a.enable(11),S.vertexUv1s&&a.enable(12),S.vertexUv2s&&a.enable(13),S.vertexUv3s&&a.enable(14),S.vertexTangents&&a.enable(15),S.anisotropy&&a.enable(16),S.alphaHash&&a.enable(17),S.batching&&a.enable(18),S.dispersion&&a.enable(19),S.retroreflection&&a.enable(24),S.diffuseRoughness&&a.enable(25),S.batchingColor&&a.enable(20),S.gradientMap&&a.enable(21),S.packedNormalMap&&a.enable(22),S.vertexNormals&&a.enable(23),b.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reversedDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),S.numLightProbeGrids>0&&a.enable(22),S.hasPositionAttribute&&a.enable(23),b.push(a.mask)}function y(b){let S=f[b.type],C;if(S){let I=Ii[S];C=Tc.clone(I.uniforms)}else C=b.uniforms;return C}function _(b,S){let C=h.get(S);return C!==void 0?++C.usedTimes:(C=new g3(n,S,b,s),c.push(C),h.set(S,C)),C}function x(b){if(--b.usedTimes===0){let S=c.indexOf(b);c[S]=c[c.length-1],c.pop(),h.delete(b.cacheKey),b.destroy()}}function T(b){o.remove(b)}function M(){o.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:y,acquireProgram:_,releaseProgram:x,releaseShaderCache:T,programs:c,dispose:M}}function x3(){let n=new WeakMap;function e(a){return n.has(a)}function t(a){let o=n.get(a);return o===void 0&&(o={},n.set(a,o)),o}function i(a){n.delete(a)}function s(a,o,l){n.get(a)[o]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function _3(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Xb(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function $b(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function a(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function o(f,d,p,v,m,g){let y=n[e];return y===void 0?(y={id:f.id,object:f,geometry:d,material:p,materialVariant:a(f),groupOrder:v,renderOrder:f.renderOrder,z:m,group:g},n[e]=y):(y.id=f.id,y.object=f,y.geometry=d,y.material=p,y.materialVariant=a(f),y.groupOrder=v,y.renderOrder=f.renderOrder,y.z=m,y.group=g),e++,y}function l(f,d,p,v,m,g,y){y.reversedDepth===!0&&(m=-m);let _=o(f,d,p,v,m,g);p.transmission>0?i.push(_):p.transparent===!0?s.push(_):t.push(_)}function c(f,d,p,v,m,g){let y=o(f,d,p,v,m,g);p.transmission>0?i.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function h(f,d){t.length>1&&t.sort(f||_3),i.length>1&&i.sort(d||Xb),s.length>1&&s.sort(d||Xb)}function u(){for(let f=e,d=n.length;f<d;f++){let p=n[f];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function w3(){let n=new WeakMap;function e(i,s){let r=n.get(i),a;return r===void 0?(a=new $b,n.set(i,[a])):s>=r.length?(a=new $b,r.push(a)):a=r[s],a}function t(){n=new WeakMap}return{get:e,dispose:t}}function S3(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new P,color:new qe};break;case"SpotLight":t={position:new P,direction:new P,color:new qe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new P,color:new qe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new P,skyColor:new qe,groundColor:new qe};break;case"RectAreaLight":t={color:new qe,position:new P,halfWidth:new P,halfHeight:new P};break}return n[e.id]=t,t}}}function M3(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Se};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Se};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Se,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var E3=0;function T3(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function A3(n){let e=new S3,t=M3(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new P);let s=new P,r=new St,a=new St;function o(c){let h=0,u=0,f=0;for(let O=0;O<9;O++)i.probe[O].set(0,0,0);let d=0,p=0,v=0,m=0,g=0,y=0,_=0,x=0,T=0,M=0,b=0,S=0,C=0,I=0;c.sort(T3);for(let O=0,z=c.length;O<z;O++){let U=c[O],G=U.color,q=U.intensity,H=U.distance,le=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===ia?le=U.shadow.map.texture:le=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=G.r*q,u+=G.g*q,f+=G.b*q;else if(U.isLightProbe){for(let j=0;j<9;j++)i.probe[j].addScaledVector(U.sh.coefficients[j],q);I++}else if(U.isSunLight){let j=e.get(U);if(j.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let te=U.shadow,ne=t.get(U);ne.shadowIntensity=te.intensity,ne.shadowBias=te.bias,ne.shadowNormalBias=te.normalBias,ne.shadowRadius=te.radius,ne.shadowMapSize.copy(te.mapSize).multiply(te.getFrameExtents()),i.sunShadow[p]=ne,i.sunShadowMap[p]=le;let pe=te.getViewportCount();for(let he=0;he<pe;he++)i.sunShadowMatrix[v+he]=te.getMatrix(he),i.sunShadowCascade[v+he]=te._cascadeData[he];v+=pe,p++}i.sun[d]=j,d++}else if(U.isDirectionalLight){let j=e.get(U);if(j.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let te=U.shadow,ne=t.get(U);ne.shadowIntensity=te.intensity,ne.shadowBias=te.bias,ne.shadowNormalBias=te.normalBias,ne.shadowRadius=te.radius,ne.shadowMapSize=te.mapSize,i.directionalShadow[m]=ne,i.directionalShadowMap[m]=le,i.directionalShadowMatrix[m]=U.shadow.matrix,T++}i.directional[m]=j,m++}else if(U.isSpotLight){let j=e.get(U);j.position.setFromMatrixPosition(U.matrixWorld),j.color.copy(G).multiplyScalar(q),j.distance=H,j.coneCos=Math.cos(U.angle),j.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),j.decay=U.decay,i.spot[y]=j;let te=U.shadow;if(U.map&&(i.spotLightMap[S]=U.map,S++,te.updateMatrices(U),U.castShadow&&C++),i.spotLightMatrix[y]=te.matrix,U.castShadow){let ne=t.get(U);ne.shadowIntensity=te.intensity,ne.shadowBias=te.bias,ne.shadowNormalBias=te.normalBias,ne.shadowRadius=te.radius,ne.shadowMapSize=te.mapSize,i.spotShadow[y]=ne,i.spotShadowMap[y]=le,b++}y++}else if(U.isRectAreaLight){let j=e.get(U);j.color.copy(G).multiplyScalar(q),j.halfWidth.set(U.width*.5,0,0),j.halfHeight.set(0,U.height*.5,0),i.rectArea[_]=j,_++}else if(U.isPointLight){let j=e.get(U);if(j.color.copy(U.color).multiplyScalar(U.intensity),j.distance=U.distance,j.decay=U.decay,U.castShadow){let te=U.shadow,ne=t.get(U);ne.shadowIntensity=te.intensity,ne.shadowBias=te.bias,ne.shadowNormalBias=te.normalBias,ne.shadowRadius=te.radius,ne.shadowMapSize=te.mapSize,ne.shadowCameraNear=te.camera.near,ne.shadowCameraFar=te.camera.far,i.pointShadow[g]=ne,i.pointShadowMap[g]=le,i.pointShadowMatrix[g]=U.shadow.matrix,M++}i.point[g]=j,g++}else if(U.isHemisphereLight){let j=e.get(U);j.skyColor.copy(U.color).multiplyScalar(q),j.groundColor.copy(U.groundColor).multiplyScalar(q),i.hemi[x]=j,x++}}_>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=f;let L=i.hash;(L.sunLength!==d||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==y||L.rectAreaLength!==_||L.hemiLength!==x||L.numSunShadows!==p||L.numDirectionalShadows!==T||L.numPointShadows!==M||L.numSpotShadows!==b||L.numSpotMaps!==S||L.numLightProbes!==I)&&(i.sun.length=d,i.directional.length=m,i.spot.length=y,i.rectArea.length=_,i.point.length=g,i.hemi.length=x,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=b,i.spotShadowMap.length=b,i.spotLightMatrix.length=b+S-C,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=C,i.numLightProbes=I,L.sunLength=d,L.directionalLength=m,L.pointLength=g,L.spotLength=y,L.rectAreaLength=_,L.hemiLength=x,L.numSunShadows=p,L.numDirectionalShadows=T,L.numPointShadows=M,L.numSpotShadows=b,L.numSpotMaps=S,L.numLightProbes=I,i.version=E3++)}function l(c,h){let u=0,f=0,d=0,p=0,v=0,m=0,g=h.matrixWorldInverse;for(let y=0,_=c.length;y<_;y++){let x=c[y];if(x.isSunLight){let T=i.sun[u];T.direction.setFromMatrixPosition(x.matrixWorld),T.direction.transformDirection(g),u++}else if(x.isDirectionalLight){let T=i.directional[f];T.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(g),f++}else if(x.isSpotLight){let T=i.spot[p];T.position.setFromMatrixPosition(x.matrixWorld),T.position.applyMatrix4(g),T.direction.setFromMatrixPosition(x.matrixWorld),s.setFromMatrixPosition(x.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(g),p++}else if(x.isRectAreaLight){let T=i.rectArea[v];T.position.setFromMatrixPosition(x.matrixWorld),T.position.applyMatrix4(g),a.identity(),r.copy(x.matrixWorld),r.premultiply(g),a.extractRotation(r),T.halfWidth.set(x.width*.5,0,0),T.halfHeight.set(0,x.height*.5,0),T.halfWidth.applyMatrix4(a),T.halfHeight.applyMatrix4(a),v++}else if(x.isPointLight){let T=i.point[d];T.position.setFromMatrixPosition(x.matrixWorld),T.position.applyMatrix4(g),d++}else if(x.isHemisphereLight){let T=i.hemi[m];T.direction.setFromMatrixPosition(x.matrixWorld),T.direction.transformDirection(g),m++}}}return{setup:o,setupView:l,state:i}}function qb(n){let e=new A3(n),t=[],i=[],s=[];function r(u){h.camera=u,t.length=0,i.length=0,s.length=0}function a(u){u.isLightProbeGrid?s.push(u):t.push(u)}function o(u){i.push(u)}function l(){e.setup(t),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function R3(n){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new qb(n),e.set(s,[o])):r>=a.length?(o=new qb(n),a.push(o)):o=a[r],o}function i(){e=new WeakMap}return{get:t,dispose:i}}var C3=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,P3=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,I3=[new P(1,0,0),new P(-1,0,0),new P(0,1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1)],L3=[new P(0,-1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1),new P(0,-1,0),new P(0,-1,0)],Yb=new St,Ac=new P,Vm=new P;function D3(n,e,t){let i=new Jr,s=new Se,r=new Se,a=new Bt,o=new gu,l=new vu,c={},h=t.maxTextureSize,u={[$s]:Pi,[Pi]:$s,[vn]:vn},f=new Fi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Se},radius:{value:4}},vertexShader:C3,fragmentShader:P3}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let p=new vt;p.setAttribute("position",new ln(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new zt(p,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=vc;let g=this.type;this.render=function(M,b,S){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||M.length===0)return;this.type===Hy&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=vc);let C=n.getRenderTarget(),I=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),O=n.state;O.setBlending(Mr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=g!==this.type;z&&b.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(G=>G.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,G=M.length;U<G;U++){let q=M[U],H=q.shadow;if(H===void 0){Je("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let le=H.getFrameExtents();s.multiply(le),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/le.x),s.x=r.x*le.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/le.y),s.y=r.y*le.y,H.mapSize.y=r.y));let j=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=j,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Uo){if(q.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new ai(s.x,s.y,{format:ia,type:Ts,minFilter:Ri,magFilter:Ri,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new Ms(s.x,s.y,hs),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=vr,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=en,H.map.depthTexture.magFilter=en}else q.isPointLight?(H.map=new Cc(s.x),H.map.depthTexture=new ql(s.x,Ji)):(H.map=new ai(s.x,s.y),H.map.depthTexture=new Ms(s.x,s.y,Ji)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=vr,this.type===vc?(H.map.depthTexture.compareFunction=j?Rm:Am,H.map.depthTexture.minFilter=Ri,H.map.depthTexture.magFilter=Ri):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=en,H.map.depthTexture.magFilter=en);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let te=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,S);let ne=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:S.layers;for(let pe=0;pe<te;pe++){let he=H.getCamera(pe);if(q.isPointLight){let Q=H.camera,fe=H.matrix,ve=q.distance||Q.far;ve!==Q.far&&(Q.far=ve,Q.updateProjectionMatrix()),Ac.setFromMatrixPosition(q.matrixWorld),Q.position.copy(Ac),Vm.copy(Q.position),Vm.add(I3[pe]),Q.up.copy(L3[pe]),Q.lookAt(Vm),Q.updateMatrixWorld(),fe.makeTranslation(-Ac.x,-Ac.y,-Ac.z),Yb.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Yb,Q.coordinateSystem,Q.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,pe),n.clear();else{pe===0&&(n.setRenderTarget(H.map),n.clear());let Q=H.getViewport(pe);a.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),O.viewport(a)}i=H.getFrustum(pe),x(b,S,he,q,ne,this.type)}H.isPointLightShadow!==!0&&this.type===Uo&&y(H,S),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(C,I,L)};function y(M,b){let S=e.update(v);f.defines.VSM_SAMPLES!==M.blurSamples&&(f.defines.VSM_SAMPLES=M.blurSamples,d.defines.VSM_SAMPLES=M.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),M.mapPass===null?M.mapPass=new ai(s.x,s.y,{format:ia,type:Ts}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),f.uniforms.shadow_pass.value=M.map.depthTexture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(b,null,S,f,v,null),d.uniforms.shadow_pass.value=M.mapPass.texture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(b,null,S,d,v,null)}function _(M,b,S,C){let I=null,L=S.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(L!==void 0)I=L;else if(I=S.isPointLight===!0?l:o,n.localClippingEnabled&&b.clipShadows===!0&&Array.isArray(b.clippingPlanes)&&b.clippingPlanes.length!==0||b.displacementMap&&b.displacementScale!==0||b.alphaMap&&b.alphaTest>0||b.map&&b.alphaTest>0||b.alphaToCoverage===!0){let O=I.uuid,z=b.uuid,U=c[O];U===void 0&&(U={},c[O]=U);let G=U[z];G===void 0&&(G=I.clone(),U[z]=G,b.addEventListener("dispose",T)),I=G}if(I.visible=b.visible,I.wireframe=b.wireframe,C===Uo?I.side=b.shadowSide!==null?b.shadowSide:b.side:I.side=b.shadowSide!==null?b.shadowSide:u[b.side],I.alphaMap=b.alphaMap,I.alphaTest=b.alphaToCoverage===!0?.5:b.alphaTest,I.map=b.map,I.clipShadows=b.clipShadows,I.clippingPlanes=b.clippingPlanes,I.clipIntersection=b.clipIntersection,I.displacementMap=b.displacementMap,I.displacementScale=b.displacementScale,I.displacementBias=b.displacementBias,I.wireframeLinewidth=b.wireframeLinewidth,I.linewidth=b.linewidth,S.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let O=n.properties.get(I);O.light=S}return I}function x(M,b,S,C,I,L){if(M.visible===!1)return;if(M.layers.test(I)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&L===Uo)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,M.matrixWorld);let U=e.update(M),G=M.material;if(Array.isArray(G)){let q=U.groups;for(let H=0,le=q.length;H<le;H++){let j=q[H],te=G[j.materialIndex];if(te&&te.visible){let ne=_(M,te,C,L);M.onBeforeShadow(n,M,b,S,U,ne,j),n.renderBufferDirect(S,null,U,ne,M,j),M.onAfterShadow(n,M,b,S,U,ne,j)}}}else if(G.visible){let q=_(M,G,C,L);M.onBeforeShadow(n,M,b,S,U,q,null),n.renderBufferDirect(S,null,U,q,M,null),M.onAfterShadow(n,M,b,S,U,q,null)}}let z=M.children;for(let U=0,G=z.length;U<G;U++)x(z[U],b,S,C,I,L)}function T(M){M.target.removeEventListener("dispose",T);for(let S in c){let C=c[S],I=M.target.uuid;I in C&&(C[I].dispose(),delete C[I])}}}function N3(n,e){function t(){let k=!1,ae=new Bt,se=null,Ae=new Bt(0,0,0,0);return{setMask:function(ye){se!==ye&&!k&&(n.colorMask(ye,ye,ye,ye),se=ye)},setLocked:function(ye){k=ye},setClear:function(ye,Me,$e,it,ue){ue===!0&&(ye*=it,Me*=it,$e*=it),ae.set(ye,Me,$e,it),Ae.equals(ae)===!1&&(n.clearColor(ye,Me,$e,it),Ae.copy(ae))},reset:function(){k=!1,se=null,Ae.set(-1,0,0,0)}}}function i(){let k=!1,ae=!1,se=null,Ae=null,ye=null;return{setReversed:function(Me){if(ae!==Me){let $e=e.get("EXT_clip_control");Me?$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.ZERO_TO_ONE_EXT):$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.NEGATIVE_ONE_TO_ONE_EXT),ae=Me;let it=ye;ye=null,this.setClear(it)}},getReversed:function(){return ae},setTest:function(Me){Me?be(n.DEPTH_TEST):Xe(n.DEPTH_TEST)},setMask:function(Me){se!==Me&&!k&&(n.depthMask(Me),se=Me)},setFunc:function(Me){if(ae&&(Me=xb[Me]),Ae!==Me){switch(Me){case $h:n.depthFunc(n.NEVER);break;case qh:n.depthFunc(n.ALWAYS);break;case Yh:n.depthFunc(n.LESS);break;case wo:n.depthFunc(n.LEQUAL);break;case jh:n.depthFunc(n.EQUAL);break;case Zh:n.depthFunc(n.GEQUAL);break;case Jh:n.depthFunc(n.GREATER);break;case Kh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=Me}},setLocked:function(Me){k=Me},setClear:function(Me){ye!==Me&&(ye=Me,ae&&(Me=1-Me),n.clearDepth(Me))},reset:function(){k=!1,se=null,Ae=null,ye=null,ae=!1}}}function s(){let k=!1,ae=null,se=null,Ae=null,ye=null,Me=null,$e=null,it=null,ue=null;return{setTest:function(ze){k||(ze?be(n.STENCIL_TEST):Xe(n.STENCIL_TEST))},setMask:function(ze){ae!==ze&&!k&&(n.stencilMask(ze),ae=ze)},setFunc:function(ze,st,Pe){(se!==ze||Ae!==st||ye!==Pe)&&(n.stencilFunc(ze,st,Pe),se=ze,Ae=st,ye=Pe)},setOp:function(ze,st,Pe){(Me!==ze||$e!==st||it!==Pe)&&(n.stencilOp(ze,st,Pe),Me=ze,$e=st,it=Pe)},setLocked:function(ze){k=ze},setClear:function(ze){ue!==ze&&(n.clearStencil(ze),ue=ze)},reset:function(){k=!1,ae=null,se=null,Ae=null,ye=null,Me=null,$e=null,it=null,ue=null}}}let r=new t,a=new i,o=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,p=[],v=null,m=!1,g=null,y=null,_=null,x=null,T=null,M=null,b=null,S=new qe(0,0,0),C=0,I=!1,L=null,O=null,z=null,U=null,G=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,le=0,j=n.getParameter(n.VERSION);j.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(j)[1]),H=le>=1):j.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(j)[1]),H=le>=2);let te=null,ne={},pe=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),Q=new Bt().fromArray(pe),fe=new Bt().fromArray(he);function ve(k,ae,se,Ae){let ye=new Uint8Array(4),Me=n.createTexture();n.bindTexture(k,Me),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $e=0;$e<se;$e++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(ae,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,ye):n.texImage2D(ae+$e,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ye);return Me}let Ee={};Ee[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Ee[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ee[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),be(n.DEPTH_TEST),a.setFunc(wo),Tn(!1),Xt(om),be(n.CULL_FACE),un(Mr);function be(k){h[k]!==!0&&(n.enable(k),h[k]=!0)}function Xe(k){h[k]!==!1&&(n.disable(k),h[k]=!1)}function ot(k,ae){return f[k]!==ae?(n.bindFramebuffer(k,ae),f[k]=ae,k===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=ae),k===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=ae),!0):!1}function Ge(k,ae){let se=p,Ae=!1;if(k){se=d.get(ae),se===void 0&&(se=[],d.set(ae,se));let ye=k.textures;if(se.length!==ye.length||se[0]!==n.COLOR_ATTACHMENT0){for(let Me=0,$e=ye.length;Me<$e;Me++)se[Me]=n.COLOR_ATTACHMENT0+Me;se.length=ye.length,Ae=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(se)}function dt(k){return v!==k?(n.useProgram(k),v=k,!0):!1}let ut={[Sa]:n.FUNC_ADD,[Gy]:n.FUNC_SUBTRACT,[Wy]:n.FUNC_REVERSE_SUBTRACT};ut[Xy]=n.MIN,ut[$y]=n.MAX;let Qe={[qy]:n.ZERO,[Yy]:n.ONE,[jy]:n.SRC_COLOR,[um]:n.SRC_ALPHA,[tb]:n.SRC_ALPHA_SATURATE,[Qy]:n.DST_COLOR,[Jy]:n.DST_ALPHA,[Zy]:n.ONE_MINUS_SRC_COLOR,[fm]:n.ONE_MINUS_SRC_ALPHA,[eb]:n.ONE_MINUS_DST_COLOR,[Ky]:n.ONE_MINUS_DST_ALPHA,[nb]:n.CONSTANT_COLOR,[ib]:n.ONE_MINUS_CONSTANT_COLOR,[sb]:n.CONSTANT_ALPHA,[rb]:n.ONE_MINUS_CONSTANT_ALPHA};function un(k,ae,se,Ae,ye,Me,$e,it,ue,ze){if(k===Mr){m===!0&&(Xe(n.BLEND),m=!1);return}if(m===!1&&(be(n.BLEND),m=!0),k!==Vy){if(k!==g||ze!==I){if((y!==Sa||T!==Sa)&&(n.blendEquation(n.FUNC_ADD),y=Sa,T=Sa),ze)switch(k){case Fo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case lm:n.blendFunc(n.ONE,n.ONE);break;case cm:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case hm:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:rt("WebGLState: Invalid blending: ",k);break}else switch(k){case Fo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case lm:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case cm:rt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hm:rt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:rt("WebGLState: Invalid blending: ",k);break}_=null,x=null,M=null,b=null,S.set(0,0,0),C=0,g=k,I=ze}return}ye=ye||ae,Me=Me||se,$e=$e||Ae,(ae!==y||ye!==T)&&(n.blendEquationSeparate(ut[ae],ut[ye]),y=ae,T=ye),(se!==_||Ae!==x||Me!==M||$e!==b)&&(n.blendFuncSeparate(Qe[se],Qe[Ae],Qe[Me],Qe[$e]),_=se,x=Ae,M=Me,b=$e),(it.equals(S)===!1||ue!==C)&&(n.blendColor(it.r,it.g,it.b,ue),S.copy(it),C=ue),g=k,I=!1}function Qt(k,ae){k.side===vn?Xe(n.CULL_FACE):be(n.CULL_FACE);let se=k.side===Pi;ae&&(se=!se),Tn(se),k.blending===Fo&&k.transparent===!1?un(Mr):un(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),a.setFunc(k.depthFunc),a.setTest(k.depthTest),a.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ae=k.stencilWrite;o.setTest(Ae),Ae&&(o.setMask(k.stencilWriteMask),o.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),o.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),Rt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?be(n.SAMPLE_ALPHA_TO_COVERAGE):Xe(n.SAMPLE_ALPHA_TO_COVERAGE)}function Tn(k){L!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),L=k)}function Xt(k){k!==By?(be(n.CULL_FACE),k!==O&&(k===om?n.cullFace(n.BACK):k===zy?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Xe(n.CULL_FACE),O=k}function Xn(k){k!==z&&(H&&n.lineWidth(k),z=k)}function Rt(k,ae,se){k?(be(n.POLYGON_OFFSET_FILL),(U!==ae||G!==se)&&(U=ae,G=se,a.getReversed()&&(ae=-ae,se=-se),n.polygonOffset(ae,se))):Xe(n.POLYGON_OFFSET_FILL)}function Fn(k){k?be(n.SCISSOR_TEST):Xe(n.SCISSOR_TEST)}function yn(k){k===void 0&&(k=n.TEXTURE0+q-1),te!==k&&(n.activeTexture(k),te=k)}function An(k,ae,se){se===void 0&&(te===null?se=n.TEXTURE0+q-1:se=te);let Ae=ne[se];Ae===void 0&&(Ae={type:void 0,texture:void 0},ne[se]=Ae),(Ae.type!==k||Ae.texture!==ae)&&(te!==se&&(n.activeTexture(se),te=se),n.bindTexture(k,ae||Ee[k]),Ae.type=k,Ae.texture=ae)}function B(){let k=ne[te];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Ie(){try{n.compressedTexImage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function Ke(){try{n.compressedTexImage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function ft(){try{n.texSubImage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function Te(){try{n.texSubImage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function Yt(){try{n.compressedTexSubImage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function Ze(){try{n.texStorage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function D(){try{n.texStorage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function E(){try{n.texImage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function $(){try{n.texImage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function de(k){return u[k]!==void 0?u[k]:n.getParameter(k)}function oe(k,ae){u[k]!==ae&&(n.pixelStorei(k,ae),u[k]=ae)}function xe(k){Q.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),Q.copy(k))}function _e(k){fe.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),fe.copy(k))}function ie(k,ae){let se=c.get(ae);se===void 0&&(se=new WeakMap,c.set(ae,se));let Ae=se.get(k);Ae===void 0&&(Ae=n.getUniformBlockIndex(ae,k.name),n.uniformBlockBinding(ae,Ae,Ae),se.set(k,Ae))}function re(k,ae,se){let ye=c.get(ae).get(k);l[ye]!==se&&(n.bindBufferBase(n.UNIFORM_BUFFER,ye,se),l[ye]=se)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),a.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},te=null,ne={},f={},l={},d=new WeakMap,p=[],v=null,m=!1,g=null,y=null,_=null,x=null,T=null,M=null,b=null,S=new qe(0,0,0),C=0,I=!1,L=null,O=null,z=null,U=null,G=null,Q.set(0,0,n.canvas.width,n.canvas.height),fe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:be,disable:Xe,bindFramebuffer:ot,drawBuffers:Ge,useProgram:dt,setBlending:un,setMaterial:Qt,setFlipSided:Tn,setCullFace:Xt,setLineWidth:Xn,setPolygonOffset:Rt,setScissorTest:Fn,activeTexture:yn,bindTexture:An,unbindTexture:B,compressedTexImage2D:Ie,compressedTexImage3D:Ke,texImage2D:E,texImage3D:$,pixelStorei:oe,getParameter:de,updateUBOMapping:ie,uniformBlockBinding:re,texStorage2D:Ze,texStorage3D:D,texSubImage2D:ft,texSubImage3D:Te,compressedTexSubImage2D:Yt,compressedTexSubImage3D:We,scissor:xe,viewport:_e,reset:ge}}function U3(n,e,t,i,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Se,h=new WeakMap,u=new Set,f,d=new WeakMap,p=new Set,v=new FinalizationRegistry(D=>p.delete(D)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(D,E){return m?new OffscreenCanvas(D,E):Bl("canvas")}function y(D,E,$){let de=1,oe=Ze(D);if((oe.width>$||oe.height>$)&&(de=$/Math.max(oe.width,oe.height)),de<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){let xe=Math.floor(de*oe.width),_e=Math.floor(de*oe.height);f===void 0&&(f=g(xe,_e));let ie=E?g(xe,_e):f;return ie.width=xe,ie.height=_e,ie.getContext("2d").drawImage(D,0,0,xe,_e),Je("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+_e+")."),ie}else return"data"in D&&Je("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),D;return D}function _(D){return D.generateMipmaps}function x(D){n.generateMipmap(D)}function T(D){return D.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?n.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(D,E,$,de,oe,xe=!1){if(D!==null){if(n[D]!==void 0)return n[D];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let _e;de&&(_e=e.get("EXT_texture_norm16"),_e||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ie=E;if(E===n.RED&&($===n.FLOAT&&(ie=n.R32F),$===n.HALF_FLOAT&&(ie=n.R16F),$===n.UNSIGNED_BYTE&&(ie=n.R8),$===n.UNSIGNED_SHORT&&_e&&(ie=_e.R16_EXT),$===n.SHORT&&_e&&(ie=_e.R16_SNORM_EXT)),E===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(ie=n.R8UI),$===n.UNSIGNED_SHORT&&(ie=n.R16UI),$===n.UNSIGNED_INT&&(ie=n.R32UI),$===n.BYTE&&(ie=n.R8I),$===n.SHORT&&(ie=n.R16I),$===n.INT&&(ie=n.R32I)),E===n.RG&&($===n.FLOAT&&(ie=n.RG32F),$===n.HALF_FLOAT&&(ie=n.RG16F),$===n.UNSIGNED_BYTE&&(ie=n.RG8),$===n.UNSIGNED_SHORT&&_e&&(ie=_e.RG16_EXT),$===n.SHORT&&_e&&(ie=_e.RG16_SNORM_EXT)),E===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(ie=n.RG8UI),$===n.UNSIGNED_SHORT&&(ie=n.RG16UI),$===n.UNSIGNED_INT&&(ie=n.RG32UI),$===n.BYTE&&(ie=n.RG8I),$===n.SHORT&&(ie=n.RG16I),$===n.INT&&(ie=n.RG32I)),E===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(ie=n.RGB8UI),$===n.UNSIGNED_SHORT&&(ie=n.RGB16UI),$===n.UNSIGNED_INT&&(ie=n.RGB32UI),$===n.BYTE&&(ie=n.RGB8I),$===n.SHORT&&(ie=n.RGB16I),$===n.INT&&(ie=n.RGB32I)),E===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(ie=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(ie=n.RGBA16UI),$===n.UNSIGNED_INT&&(ie=n.RGBA32UI),$===n.BYTE&&(ie=n.RGBA8I),$===n.SHORT&&(ie=n.RGBA16I),$===n.INT&&(ie=n.RGBA32I)),E===n.RGB&&($===n.UNSIGNED_SHORT&&_e&&(ie=_e.RGB16_EXT),$===n.SHORT&&_e&&(ie=_e.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(ie=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(ie=n.R11F_G11F_B10F)),E===n.RGBA){let re=xe?kl:Et.getTransfer(oe);$===n.FLOAT&&(ie=n.RGBA32F),$===n.HALF_FLOAT&&(ie=n.RGBA16F),$===n.UNSIGNED_BYTE&&(ie=re===kt?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&_e&&(ie=_e.RGBA16_EXT),$===n.SHORT&&_e&&(ie=_e.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(ie=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(ie=n.RGB5_A1)}return(ie===n.R16F||ie===n.R32F||ie===n.RG16F||ie===n.RG32F||ie===n.RGBA16F||ie===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function b(D,E){let $;return D?E===null||E===Ji||E===Ea?$=n.DEPTH24_STENCIL8:E===hs?$=n.DEPTH32F_STENCIL8:E===ko&&($=n.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===Ji||E===Ea?$=n.DEPTH_COMPONENT24:E===hs?$=n.DEPTH_COMPONENT32F:E===ko&&($=n.DEPTH_COMPONENT16),$}function S(D,E){return _(D)===!0||D.isFramebufferTexture&&D.minFilter!==en&&D.minFilter!==Ri?Math.log2(Math.max(E.width,E.height))+1:D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?E.mipmaps.length:1}function C(D){let E=new WeakRef(D);i.get(D).__ref=E,p.add(E),v.register(D,E,E)}function I(D){let E=i.get(D).__ref;E!==void 0&&(p.delete(E),v.unregister(E))}function L(D){z(D.target)}function O(D){U(D.target)}function z(D){D.removeEventListener("dispose",L),I(D),q(D),D.isVideoTexture&&h.delete(D),D.isHTMLTexture&&u.delete(D)}function U(D){D.removeEventListener("dispose",O),I(D),le(D)}function G(){for(let D of p){let E=D.deref();E!==void 0&&(E.isRenderTarget===!0?U(E):z(E))}p.clear(),u.clear()}function q(D){let E=i.get(D);if(E.__webglInit===void 0)return;let $=D.source,de=d.get($);if(de){let oe=de[E.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(D),Object.keys(de).length===0&&d.delete($)}i.remove(D)}function H(D){let E=i.get(D);n.deleteTexture(E.__webglTexture);let $=D.source,de=d.get($);delete de[E.__cacheKey],a.memory.textures--}function le(D){let E=i.get(D);E.__depthDisposeCallback&&E.__depthDisposeCallback();let $=D.depthTexture;if($&&$.renderTarget===D&&z($),D.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(E.__webglFramebuffer[oe]))for(let xe=0;xe<E.__webglFramebuffer[oe].length;xe++)n.deleteFramebuffer(E.__webglFramebuffer[oe][xe]);else n.deleteFramebuffer(E.__webglFramebuffer[oe]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[oe])}else{if(Array.isArray(E.__webglFramebuffer))for(let oe=0;oe<E.__webglFramebuffer.length;oe++)n.deleteFramebuffer(E.__webglFramebuffer[oe]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let oe=0;oe<E.__webglColorRenderbuffer.length;oe++)E.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[oe]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let de=D.textures;for(let oe=0,xe=de.length;oe<xe;oe++){let _e=i.get(de[oe]);_e.__webglTexture&&(n.deleteTexture(_e.__webglTexture),a.memory.textures--),i.remove(de[oe])}i.remove(D)}let j=0;function te(){j=0}function ne(){return j}function pe(D){j=D}function he(){let D=j;return D>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(D+1)+" texture units while this GPU supports only "+s.maxTextures),j+=1,D}function Q(D){let E=[];return E.push(D.wrapS),E.push(D.wrapT),E.push(D.wrapR||0),E.push(D.magFilter),E.push(D.minFilter),E.push(D.anisotropy),E.push(D.internalFormat),E.push(D.format),E.push(D.type),E.push(D.generateMipmaps),E.push(D.mipmapsAutoUpdate),E.push(D.premultiplyAlpha),E.push(D.flipY),E.push(D.unpackAlignment),E.push(D.colorSpace),E.join()}function fe(D,E){let $=i.get(D);if(D.isVideoTexture&&Yt(D),D.isRenderTargetTexture===!1&&D.isExternalTexture!==!0&&D.version>0&&$.__version!==D.version){let de=D.image;if(de===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{Qt($,D,E);return}}else D.isExternalTexture&&($.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+E)}function ve(D,E){let $=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&$.__version!==D.version){Qt($,D,E);return}else D.isExternalTexture&&($.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+E)}function Ee(D,E){let $=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&$.__version!==D.version){Qt($,D,E);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+E)}function be(D,E){let $=i.get(D);if(D.version>0&&$.__version!==D.version){Tn($,D,E);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+E)}let Xe={[Qh]:n.REPEAT,[Hs]:n.CLAMP_TO_EDGE,[eu]:n.MIRRORED_REPEAT},ot={[en]:n.NEAREST,[lb]:n.NEAREST_MIPMAP_NEAREST,[yc]:n.NEAREST_MIPMAP_LINEAR,[Ri]:n.LINEAR,[Du]:n.LINEAR_MIPMAP_NEAREST,[Er]:n.LINEAR_MIPMAP_LINEAR},Ge={[fb]:n.NEVER,[Cm]:n.ALWAYS,[db]:n.LESS,[Am]:n.LEQUAL,[pb]:n.EQUAL,[Rm]:n.GEQUAL,[mb]:n.GREATER,[gb]:n.NOTEQUAL};function dt(D,E){if(E.type===hs&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===Ri||E.magFilter===Du||E.magFilter===yc||E.magFilter===Er||E.minFilter===Ri||E.minFilter===Du||E.minFilter===yc||E.minFilter===Er)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(D,n.TEXTURE_WRAP_S,Xe[E.wrapS]),n.texParameteri(D,n.TEXTURE_WRAP_T,Xe[E.wrapT]),(D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY)&&n.texParameteri(D,n.TEXTURE_WRAP_R,Xe[E.wrapR]),n.texParameteri(D,n.TEXTURE_MAG_FILTER,ot[E.magFilter]),n.texParameteri(D,n.TEXTURE_MIN_FILTER,ot[E.minFilter]),E.compareFunction&&(n.texParameteri(D,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(D,n.TEXTURE_COMPARE_FUNC,Ge[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===en||E.minFilter!==yc&&E.minFilter!==Er||E.type===hs&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(D,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function ut(D,E){let $=!1;D.__webglInit===void 0&&(D.__webglInit=!0,E.addEventListener("dispose",L),C(E));let de=E.source,oe=d.get(de);oe===void 0&&(oe={},d.set(de,oe));let xe=Q(E);if(xe!==D.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:n.createTexture(),usedTimes:0},a.memory.textures++,$=!0),oe[xe].usedTimes++;let _e=oe[D.__cacheKey];_e!==void 0&&(oe[D.__cacheKey].usedTimes--,_e.usedTimes===0&&H(E)),D.__cacheKey=xe,D.__webglTexture=oe[xe].texture}return $}function Qe(D,E,$){return Math.floor(Math.floor(D/$)/E)}function un(D,E,$,de){let xe=D.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,$,de,E.data);else{xe.sort((k,ae)=>k.start-ae.start);let _e=0;for(let k=1;k<xe.length;k++){let ae=xe[_e],se=xe[k],Ae=ae.start+ae.count,ye=Qe(se.start,E.width,4),Me=Qe(ae.start,E.width,4);se.start<=Ae+1&&ye===Me&&Qe(se.start+se.count-1,E.width,4)===ye?ae.count=Math.max(ae.count,se.start+se.count-ae.start):(++_e,xe[_e]=se)}xe.length=_e+1;let ie=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let k=0,ae=xe.length;k<ae;k++){let se=xe[k],Ae=Math.floor(se.start/4),ye=Math.ceil(se.count/4),Me=Ae%E.width,$e=Math.floor(Ae/E.width),it=ye,ue=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(n.UNPACK_SKIP_ROWS,$e),t.texSubImage2D(n.TEXTURE_2D,0,Me,$e,it,ue,$,de,E.data)}D.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ie),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function Qt(D,E,$){let de=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(de=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(de=n.TEXTURE_3D);let oe=ut(D,E),xe=E.source;t.bindTexture(de,D.__webglTexture,n.TEXTURE0+$);let _e=i.get(xe);if(xe.version!==_e.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let ue=Et.getPrimaries(Et.workingColorSpace),ze=E.colorSpace===Ar?null:Et.getPrimaries(E.colorSpace),st=E.colorSpace===Ar||ue===ze?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st)}t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let re=y(E.image,!1,s.maxTextureSize);re=We(E,re);let ge=r.convert(E.format,E.colorSpace),k=r.convert(E.type),ae=M(E.internalFormat,ge,k,E.normalized,E.colorSpace,E.isVideoTexture);dt(de,E);let se,Ae=E.mipmaps,ye=E.isVideoTexture!==!0,Me=_e.__version===void 0||oe===!0,$e=xe.dataReady,it=S(E,re);if(E.isDepthTexture)ae=b(E.format===Tr,E.type),Me&&(ye?t.texStorage2D(n.TEXTURE_2D,1,ae,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,ae,re.width,re.height,0,ge,k,null));else if(E.isDataTexture)if(Ae.length>0){ye&&Me&&t.texStorage2D(n.TEXTURE_2D,it,ae,Ae[0].width,Ae[0].height);for(let ue=0,ze=Ae.length;ue<ze;ue++)se=Ae[ue],ye?$e&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,se.width,se.height,ge,k,se.data):t.texImage2D(n.TEXTURE_2D,ue,ae,se.width,se.height,0,ge,k,se.data);E.generateMipmaps=!1}else ye?(Me&&t.texStorage2D(n.TEXTURE_2D,it,ae,re.width,re.height),$e&&un(E,re,ge,k)):t.texImage2D(n.TEXTURE_2D,0,ae,re.width,re.height,0,ge,k,re.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){ye&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,it,ae,Ae[0].width,Ae[0].height,re.depth);for(let ue=0,ze=Ae.length;ue<ze;ue++)if(se=Ae[ue],E.format!==As)if(ge!==null)if(ye){if($e)if(E.layerUpdates.size>0){let st=zm(se.width,se.height,E.format,E.type);for(let Pe of E.layerUpdates){let pt=se.data.subarray(Pe*st/se.data.BYTES_PER_ELEMENT,(Pe+1)*st/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,Pe,se.width,se.height,1,ge,pt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,se.width,se.height,re.depth,ge,se.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ue,ae,se.width,se.height,re.depth,0,se.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?$e&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,se.width,se.height,re.depth,ge,k,se.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ue,ae,se.width,se.height,re.depth,0,ge,k,se.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{ye&&Me&&t.texStorage2D(n.TEXTURE_2D,it,ae,Ae[0].width,Ae[0].height);for(let ue=0,ze=Ae.length;ue<ze;ue++)se=Ae[ue],E.format!==As?ge!==null?ye?$e&&t.compressedTexSubImage2D(n.TEXTURE_2D,ue,0,0,se.width,se.height,ge,se.data):t.compressedTexImage2D(n.TEXTURE_2D,ue,ae,se.width,se.height,0,se.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?$e&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,se.width,se.height,ge,k,se.data):t.texImage2D(n.TEXTURE_2D,ue,ae,se.width,se.height,0,ge,k,se.data)}else if(E.isDataArrayTexture)if(ye){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,it,ae,re.width,re.height,re.depth),$e)if(E.layerUpdates.size>0){let ue=zm(re.width,re.height,E.format,E.type);for(let ze of E.layerUpdates){let st=re.data.subarray(ze*ue/re.data.BYTES_PER_ELEMENT,(ze+1)*ue/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ze,re.width,re.height,1,ge,k,st)}E.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,ge,k,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,ae,re.width,re.height,re.depth,0,ge,k,re.data);else if(E.isData3DTexture)ye?(Me&&t.texStorage3D(n.TEXTURE_3D,it,ae,re.width,re.height,re.depth),$e&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,ge,k,re.data)):t.texImage3D(n.TEXTURE_3D,0,ae,re.width,re.height,re.depth,0,ge,k,re.data);else if(E.isFramebufferTexture){if(Me)if(ye)t.texStorage2D(n.TEXTURE_2D,it,ae,re.width,re.height);else{let ue=re.width,ze=re.height;for(let st=0;st<it;st++)t.texImage2D(n.TEXTURE_2D,st,ae,ue,ze,0,ge,k,null),ue>>=1,ze>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){let ue=n.canvas;if(ue.hasAttribute("layoutsubtree")||ue.setAttribute("layoutsubtree","true"),re.parentNode!==ue){ue.appendChild(re),u.add(E),ue.onpaint=ze=>{let st=ze.changedElements;for(let Pe of u)st.includes(Pe.image)&&(Pe.needsUpdate=!0)},ue.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let st=n.RGBA,Pe=n.RGBA,pt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,st,Pe,pt,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(ye&&Me){let ue=Ze(Ae[0]);t.texStorage2D(n.TEXTURE_2D,it,ae,ue.width,ue.height)}for(let ue=0,ze=Ae.length;ue<ze;ue++)se=Ae[ue],ye?$e&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ge,k,se):t.texImage2D(n.TEXTURE_2D,ue,ae,ge,k,se);E.generateMipmaps=!1}else if(ye){if(Me){let ue=Ze(re);t.texStorage2D(n.TEXTURE_2D,it,ae,ue.width,ue.height)}$e&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,k,re)}else t.texImage2D(n.TEXTURE_2D,0,ae,ge,k,re);_(E)&&E.mipmapsAutoUpdate===!0&&x(de),_e.__version=xe.version,E.onUpdate&&E.onUpdate(E)}D.__version=E.version}function Tn(D,E,$){if(E.image.length!==6)return;let de=ut(D,E),oe=E.source;t.bindTexture(n.TEXTURE_CUBE_MAP,D.__webglTexture,n.TEXTURE0+$);let xe=i.get(oe);if(oe.version!==xe.__version||de===!0){t.activeTexture(n.TEXTURE0+$);let _e=Et.getPrimaries(Et.workingColorSpace),ie=E.colorSpace===Ar?null:Et.getPrimaries(E.colorSpace),re=E.colorSpace===Ar||_e===ie?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let ge=E.isCompressedTexture||E.image[0].isCompressedTexture,k=E.image[0]&&E.image[0].isDataTexture,ae=[];for(let Pe=0;Pe<6;Pe++)!ge&&!k?ae[Pe]=y(E.image[Pe],!0,s.maxCubemapSize):ae[Pe]=k?E.image[Pe].image:E.image[Pe],ae[Pe]=We(E,ae[Pe]);let se=ae[0],Ae=r.convert(E.format,E.colorSpace),ye=r.convert(E.type),Me=M(E.internalFormat,Ae,ye,E.normalized,E.colorSpace),$e=E.isVideoTexture!==!0,it=xe.__version===void 0||de===!0,ue=oe.dataReady,ze=S(E,se);dt(n.TEXTURE_CUBE_MAP,E);let st;if(E.isDepthTexture){if(Me=b(E.format===Tr,E.type),it)if($e)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Me,se.width,se.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Me,se.width,se.height,0,Ae,ye,null)}else if(ge){$e&&it&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Me,se.width,se.height);for(let Pe=0;Pe<6;Pe++){st=ae[Pe].mipmaps;for(let pt=0;pt<st.length;pt++){let nn=st[pt];E.format!==As?Ae!==null?$e?ue&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,pt,0,0,nn.width,nn.height,Ae,nn.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,pt,Me,nn.width,nn.height,0,nn.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,pt,0,0,nn.width,nn.height,Ae,ye,nn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,pt,Me,nn.width,nn.height,0,Ae,ye,nn.data)}}}else{if(st=E.mipmaps,$e&&it){st.length>0&&ze++;let Pe=Ze(ae[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Me,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(k){$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,ae[Pe].width,ae[Pe].height,Ae,ye,ae[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Me,ae[Pe].width,ae[Pe].height,0,Ae,ye,ae[Pe].data);for(let pt=0;pt<st.length;pt++){let xi=st[pt].image[Pe].image;$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,pt+1,0,0,xi.width,xi.height,Ae,ye,xi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,pt+1,Me,xi.width,xi.height,0,Ae,ye,xi.data)}}else{$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Ae,ye,ae[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Me,Ae,ye,ae[Pe]);for(let pt=0;pt<st.length;pt++){let nn=st[pt];$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,pt+1,0,0,Ae,ye,nn.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,pt+1,Me,Ae,ye,nn.image[Pe])}}}_(E)&&E.mipmapsAutoUpdate===!0&&x(n.TEXTURE_CUBE_MAP),xe.__version=oe.version,E.onUpdate&&E.onUpdate(E)}D.__version=E.version}function Xt(D,E,$,de,oe,xe){let _e=r.convert($.format,$.colorSpace),ie=r.convert($.type),re=M($.internalFormat,_e,ie,$.normalized,$.colorSpace),ge=i.get(E),k=i.get($);if(k.__renderTarget=E,!ge.__hasExternalTextures){let ae=Math.max(1,E.width>>xe),se=Math.max(1,E.height>>xe);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,re,ae,se,E.depth,0,_e,ie,null):t.texImage2D(oe,xe,re,ae,se,0,_e,ie,null)}t.bindFramebuffer(n.FRAMEBUFFER,D),Te(E)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,oe,k.__webglTexture,0,ft(E)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,de,oe,k.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Xn(D,E,$){if(n.bindRenderbuffer(n.RENDERBUFFER,D),E.depthBuffer){let de=E.depthTexture,oe=de&&de.isDepthTexture?de.type:null,xe=b(E.stencilBuffer,oe),_e=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Te(E)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ft(E),xe,E.width,E.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ft(E),xe,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,xe,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,_e,n.RENDERBUFFER,D)}else{let de=E.textures;for(let oe=0;oe<de.length;oe++){let xe=de[oe],_e=r.convert(xe.format,xe.colorSpace),ie=r.convert(xe.type),re=M(xe.internalFormat,_e,ie,xe.normalized,xe.colorSpace);Te(E)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ft(E),re,E.width,E.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ft(E),re,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,re,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Rt(D,E,$){let de=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,D),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(E.depthTexture);oe.__renderTarget=E;let xe=de?E.depthTexture.image[0]:E.depthTexture.image;(!oe.__webglTexture||xe.width!==E.width||xe.height!==E.height)&&(xe.width=E.width,xe.height=E.height,E.depthTexture.needsUpdate=!0),de?be(E.depthTexture,0):fe(E.depthTexture,0);let _e=oe.__webglTexture,ie=ft(E),re=de?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,ge=E.depthTexture.format===Tr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===vr)Te(E)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,re,_e,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,ge,re,_e,0);else if(E.depthTexture.format===Tr)Te(E)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,re,_e,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,ge,re,_e,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Fn(D){let E=i.get(D),$=D.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==D.depthTexture){let de=D.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),de){let oe=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,de.removeEventListener("dispose",oe)};de.addEventListener("dispose",oe),E.__depthDisposeCallback=oe}E.__boundDepthTexture=de}if(D.depthTexture&&!E.__autoAllocateDepthBuffer)if($)for(let de=0;de<6;de++)Rt(E.__webglFramebuffer[de],D,de);else D.texture.mipmaps.length>0?Rt(E.__webglFramebuffer[0],D,0):Rt(E.__webglFramebuffer,D,0);else if($){E.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[de]),E.__webglDepthbuffer[de]===void 0)E.__webglDepthbuffer[de]=n.createRenderbuffer(),Xn(E.__webglDepthbuffer[de],D,!1);else{let oe=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=E.__webglDepthbuffer[de];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}}else if(D.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),Xn(E.__webglDepthbuffer,D,!1);else{let oe=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function yn(D,E,$){let de=i.get(D);E!==void 0&&Xt(de.__webglFramebuffer,D,D.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&Fn(D)}function An(D){let E=D.texture,$=i.get(D),de=i.get(E);D.addEventListener("dispose",O),C(D);let oe=D.textures,xe=D.isWebGLCubeRenderTarget===!0,_e=oe.length>1;if(_e||(de.__webglTexture===void 0&&(de.__webglTexture=n.createTexture()),de.__version=E.version,a.memory.textures++),xe){$.__webglFramebuffer=[];for(let ie=0;ie<6;ie++)if(E.mipmaps.length>0){$.__webglFramebuffer[ie]=[];for(let re=0;re<E.mipmaps.length;re++)$.__webglFramebuffer[ie][re]=n.createFramebuffer()}else $.__webglFramebuffer[ie]=n.createFramebuffer()}else{if(E.mipmaps.length>0){$.__webglFramebuffer=[];for(let ie=0;ie<E.mipmaps.length;ie++)$.__webglFramebuffer[ie]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(_e)for(let ie=0,re=oe.length;ie<re;ie++){let ge=i.get(oe[ie]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),a.memory.textures++)}if(D.samples>0&&Te(D)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ie=0;ie<oe.length;ie++){let re=oe[ie];$.__webglColorRenderbuffer[ie]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[ie]);let ge=r.convert(re.format,re.colorSpace),k=r.convert(re.type),ae=M(re.internalFormat,ge,k,re.normalized,re.colorSpace,D.isXRRenderTarget===!0),se=ft(D);n.renderbufferStorageMultisample(n.RENDERBUFFER,se,ae,D.width,D.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ie,n.RENDERBUFFER,$.__webglColorRenderbuffer[ie])}n.bindRenderbuffer(n.RENDERBUFFER,null),D.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Xn($.__webglDepthRenderbuffer,D,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,de.__webglTexture),dt(n.TEXTURE_CUBE_MAP,E);for(let ie=0;ie<6;ie++)if(E.mipmaps.length>0)for(let re=0;re<E.mipmaps.length;re++)Xt($.__webglFramebuffer[ie][re],D,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,re);else Xt($.__webglFramebuffer[ie],D,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,0);_(E)?x(n.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}else if(_e){for(let ie=0,re=oe.length;ie<re;ie++){let ge=oe[ie],k=i.get(ge),ae=n.TEXTURE_2D;(D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ae=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ae,k.__webglTexture),dt(ae,ge),Xt($.__webglFramebuffer,D,ge,n.COLOR_ATTACHMENT0+ie,ae,0),_(ge)&&x(ae)}t.unbindTexture()}else{let ie=n.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ie=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ie,de.__webglTexture),dt(ie,E),E.mipmaps.length>0)for(let re=0;re<E.mipmaps.length;re++)Xt($.__webglFramebuffer[re],D,E,n.COLOR_ATTACHMENT0,ie,re);else Xt($.__webglFramebuffer,D,E,n.COLOR_ATTACHMENT0,ie,0);_(E)?x(ie):E.mipmaps.length>0&&n.texParameteri(ie,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}D.depthBuffer&&Fn(D)}function B(D){let E=D.textures;for(let $=0,de=E.length;$<de;$++){let oe=E[$];if(_(oe)&&oe.mipmapsAutoUpdate===!0){let xe=T(D),_e=i.get(oe).__webglTexture;t.bindTexture(xe,_e),x(xe),t.unbindTexture()}}}let Ie=[];function Ke(D){if(D.samples>0){if(Te(D)===!1){let E=D.textures,$=D.width,de=D.height,oe=n.COLOR_BUFFER_BIT,xe=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=i.get(D),ie=E.length>1;if(ie)for(let ge=0;ge<E.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,_e.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,_e.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,_e.__webglMultisampledFramebuffer),D.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,_e.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,_e.__webglFramebuffer);for(let ge=0;ge<E.length;ge++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),ie){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,_e.__webglColorRenderbuffer[ge]);let k=i.get(E[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,$,de,0,0,$,de,oe,n.NEAREST),l===!0&&(Ie.length=0,Ie.push(n.COLOR_ATTACHMENT0+ge),D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&Ie.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ie)for(let ge=0;ge<E.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,_e.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,_e.__webglColorRenderbuffer[ge]);let k=i.get(E[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,_e.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,_e.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&l){let E=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function ft(D){return Math.min(s.maxSamples,D.samples)}function Te(D){let E=i.get(D);return D.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Yt(D){let E=a.render.frame;h.get(D)!==E&&(h.set(D,E),D.update())}function We(D,E){let $=D.colorSpace,de=D.format,oe=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||$!==Ol&&$!==Ar&&(Et.getTransfer($)===kt?(de!==As||oe!==Oi)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):rt("WebGLTextures: Unsupported texture color space:",$)),E}function Ze(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=te,this.getTextureUnits=ne,this.setTextureUnits=pe,this.setTexture2D=fe,this.setTexture2DArray=ve,this.setTexture3D=Ee,this.setTextureCube=be,this.rebindTextures=yn,this.setupRenderTarget=An,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=Fn,this.setupFrameBufferTexture=Xt,this.useMultisampledRTT=Te,this.dispose=G}function F3(n,e){function t(i,s=Ar){let r,a=Et.getTransfer(s);if(i===Oi)return n.UNSIGNED_BYTE;if(i===Uu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Fu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Sm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Mm)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===_m)return n.BYTE;if(i===wm)return n.SHORT;if(i===ko)return n.UNSIGNED_SHORT;if(i===Nu)return n.INT;if(i===Ji)return n.UNSIGNED_INT;if(i===hs)return n.FLOAT;if(i===Ts)return n.HALF_FLOAT;if(i===Em)return n.ALPHA;if(i===Tm)return n.RGB;if(i===As)return n.RGBA;if(i===vr)return n.DEPTH_COMPONENT;if(i===Tr)return n.DEPTH_STENCIL;if(i===Ou)return n.RED;if(i===ku)return n.RED_INTEGER;if(i===ia)return n.RG;if(i===Bu)return n.RG_INTEGER;if(i===zu)return n.RGBA_INTEGER;if(i===bc||i===xc||i===_c||i===wc)if(a===kt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===bc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===xc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===_c)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===wc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===bc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===xc)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===_c)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===wc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Hu||i===Vu||i===Gu||i===Wu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Hu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Vu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Gu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Wu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Xu||i===$u||i===qu||i===Yu||i===ju||i===Sc||i===Zu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Xu||i===$u)return a===kt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===qu)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Yu)return r.COMPRESSED_R11_EAC;if(i===ju)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Sc)return r.COMPRESSED_RG11_EAC;if(i===Zu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ju||i===Ku||i===Qu||i===ef||i===tf||i===nf||i===sf||i===rf||i===af||i===of||i===lf||i===cf||i===hf||i===uf)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ju)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ku)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Qu)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ef)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===tf)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===nf)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===sf)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===rf)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===af)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===of)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===lf)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===cf)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===hf)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===uf)return a===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===ff||i===df||i===pf)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===ff)return a===kt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===df)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===pf)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===mf||i===gf||i===Mc||i===vf)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===mf)return r.COMPRESSED_RED_RGTC1_EXT;if(i===gf)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Mc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===vf)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ea?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var O3=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,k3=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,jm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Yl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Fi({vertexShader:O3,fragmentShader:k3,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new zt(new rc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Zm=class extends _s{constructor(e,t){super();let i=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,p=null,v=typeof XRWebGLBinding<"u",m=new jm,g={},y=t.getContextAttributes(),_=null,x=null,T=[],M=[],b=new Se,S=null,C=null,I=new En;I.viewport=new Bt;let L=new En;L.viewport=new Bt;let O=[I,L],z=new Cu,U=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let fe=T[Q];return fe===void 0&&(fe=new Ro,T[Q]=fe),fe.getTargetRaySpace()},this.getControllerGrip=function(Q){let fe=T[Q];return fe===void 0&&(fe=new Ro,T[Q]=fe),fe.getGripSpace()},this.getHand=function(Q){let fe=T[Q];return fe===void 0&&(fe=new Ro,T[Q]=fe),fe.getHandSpace()};function q(Q){let fe=M.indexOf(Q.inputSource);if(fe===-1)return;let ve=T[fe];ve!==void 0&&(ve.update(Q.inputSource,Q.frame,c||a),ve.dispatchEvent({type:Q.type,data:Q.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",le);for(let Q=0;Q<T.length;Q++){let fe=M[Q];fe!==null&&(M[Q]=null,T[Q].disconnect(fe))}U=null,G=null,m.reset();for(let Q in g)delete g[Q];if(e.setRenderTarget(_),d=null,f=null,u=null,s=null,x=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(S),e.setSize(b.width,b.height,!1),C!==null){let Q=C.camera;Q.fov=C.fov,Q.zoom=C.zoom,Q.updateProjectionMatrix(),C=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){o=Q,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&v&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(_=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",le),y.xrCompatible!==!0&&await t.makeXRCompatible(),S=e.getPixelRatio(),e.getSize(b),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ee=null,be=null;y.depth&&(be=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=y.stencil?Tr:vr,Ee=y.stencil?Ea:Ji);let Xe={colorFormat:t.RGBA8,depthFormat:be,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(Xe),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),x=new ai(f.textureWidth,f.textureHeight,{format:As,type:Oi,depthTexture:new Ms(f.textureWidth,f.textureHeight,Ee,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ve={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),x=new ai(d.framebufferWidth,d.framebufferHeight,{format:As,type:Oi,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function le(Q){for(let fe=0;fe<Q.removed.length;fe++){let ve=Q.removed[fe],Ee=M.indexOf(ve);Ee>=0&&(M[Ee]=null,T[Ee].disconnect(ve))}for(let fe=0;fe<Q.added.length;fe++){let ve=Q.added[fe],Ee=M.indexOf(ve);if(Ee===-1){for(let Xe=0;Xe<T.length;Xe++)if(Xe>=M.length){M.push(ve),Ee=Xe;break}else if(M[Xe]===null){M[Xe]=ve,Ee=Xe;break}if(Ee===-1)break}let be=T[Ee];be&&be.connect(ve)}}function j(Q,fe){fe===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(fe.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let fe=Q.near,ve=Q.far;m.texture!==null&&(m.depthNear>0&&(fe=m.depthNear),m.depthFar>0&&(ve=m.depthFar)),z.near=L.near=I.near=fe,z.far=L.far=I.far=ve,(U!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),U=z.near,G=z.far),z.layers.mask=Q.layers.mask|6,I.layers.mask=z.layers.mask&-5,L.layers.mask=z.layers.mask&-3;let Ee=Q.parent,be=z.cameras;j(z,Ee);for(let Xe=0;Xe<be.length;Xe++)j(be[Xe],Ee);z.projectionMatrix.copy(I.projectionMatrix),z.projectionMatrixInverse.copy(I.projectionMatrixInverse),C===null&&Q.isPerspectiveCamera&&(C={camera:Q,fov:Q.fov,zoom:Q.zoom}),te(Q,z,Ee)};function te(Q,fe,ve){ve===null?Q.matrix.copy(fe.matrixWorld):(Q.matrix.copy(ve.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(fe.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(fe.projectionMatrix),Q.projectionMatrixInverse.copy(fe.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Eo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(Q){return g[Q]};let ne=null;function pe(Q,fe){if(h=fe.getViewerPose(c||a),p=fe,h!==null){let ve=h.views;d!==null&&(e.setRenderTargetFramebuffer(x,d.framebuffer),e.setRenderTarget(x));let Ee=!1;ve.length!==z.cameras.length&&(z.cameras.length=0,Ee=!0);for(let Ge=0;Ge<ve.length;Ge++){let dt=ve[Ge],ut=null;if(d!==null)ut=d.getViewport(dt);else{let un=u.getViewSubImage(f,dt);ut=un.viewport,Ge===0&&(e.setRenderTargetTextures(x,un.colorTexture,un.depthStencilTexture),e.setRenderTarget(x))}let Qe=O[Ge];Qe===void 0&&(Qe=new En,Qe.layers.enable(Ge),Qe.viewport=new Bt,O[Ge]=Qe),Qe.matrix.fromArray(dt.transform.matrix),Qe.matrix.decompose(Qe.position,Qe.quaternion,Qe.scale),Qe.projectionMatrix.fromArray(dt.projectionMatrix),Qe.projectionMatrixInverse.copy(Qe.projectionMatrix).invert(),Qe.viewport.set(ut.x,ut.y,ut.width,ut.height),Ge===0&&(z.matrix.copy(Qe.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Ee===!0&&z.cameras.push(Qe)}let be=s.enabledFeatures;if(be&&be.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){u=i.getBinding();let Ge=u.getDepthInformation(ve[0]);Ge&&Ge.isValid&&Ge.texture&&m.init(Ge,s.renderState)}if(be&&be.includes("camera-access")&&v){e.state.unbindTexture(),u=i.getBinding();for(let Ge=0;Ge<ve.length;Ge++){let dt=ve[Ge].camera;if(dt){let ut=g[dt];ut||(ut=new Yl,g[dt]=ut);let Qe=u.getCameraImage(dt);ut.sourceTexture=Qe}}}}for(let ve=0;ve<T.length;ve++){let Ee=M[ve],be=T[ve];Ee!==null&&be!==void 0&&be.update(Ee,fe,c||a)}ne&&ne(Q,fe),fe.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:fe}),p=null}let he=new jb;he.setAnimationLoop(pe),this.setAnimationLoop=function(Q){ne=Q},this.dispose=function(){}}},B3=new St,rx=new nt;rx.set(-1,0,0,0,1,0,0,0,1);function z3(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Om(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,_,x){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),f(m,g),g.isMeshPhysicalMaterial&&d(m,g,x)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),v(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(a(m,g),g.isLineDashedMaterial&&o(m,g)):g.isPointsMaterial?l(m,g,y,_):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Pi&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Pi&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=e.get(g),_=y.envMap,x=y.envMapRotation;_&&(m.envMap.value=_,m.envMapRotation.value.setFromMatrix4(B3.makeRotationFromEuler(x)).transpose(),_.isCubeTexture&&_.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(rx),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function a(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function o(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,y,_){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=_*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function f(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function d(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Pi&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function v(m,g){let y=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function H3(n,e,t,i){let s={},r={};function a(y,_){let x=_.program;i.uniformBlockBinding(y,x,s[y.id])}function o(y,_){let x=s[y.id];x===void 0&&(p(y),x=l(y),s[y.id]=x,y.addEventListener("dispose",m));let T=_.program;i.updateUBOMapping(y,T);let M=e.render.frame;r[y.id]!==M&&(c(y),r[y.id]=M)}function l(y){let _=n.createBuffer(),x=y.__size,T=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,_),n.bufferData(n.UNIFORM_BUFFER,x,T),n.bindBuffer(n.UNIFORM_BUFFER,null),_}function c(y){let _=s[y.id],x=y.uniforms,T=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,_);for(let M=0,b=x.length;M<b;M++){let S=x[M];if(Array.isArray(S))for(let C=0,I=S.length;C<I;C++)h(S[C],M,C,T);else h(S,M,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(y,_,x,T){if(f(y,_,x,T)===!0){let M=y.__offset,b=y.value;if(Array.isArray(b)){let S=0;for(let C=0;C<b.length;C++){let I=b[C],L=v(I,!0);u(I,y.__data,S),S+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(b,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,y.__data)}}function u(y,_,x){typeof y=="number"||typeof y=="boolean"?_[x]=y:y.isMatrix3?(_[x]=y.elements[0],_[x+1]=y.elements[1],_[x+2]=y.elements[2],_[x+3]=0,_[x+4]=y.elements[3],_[x+5]=y.elements[4],_[x+6]=y.elements[5],_[x+7]=0,_[x+8]=y.elements[6],_[x+9]=y.elements[7],_[x+10]=y.elements[8],_[x+11]=0):ArrayBuffer.isView(y)?_.set(y.subarray(0,_.length-x),x):y.toArray(_,x)}function f(y,_,x,T){let M=y.value,b=_+"_"+x;if(Array.isArray(M)){T[b]===void 0&&(T[b]=[]);let S=T[b],C=!1;for(let I=0;I<M.length;I++)d(M[I],S,I)===!0&&(C=!0);return C}return d(M,T,b)}function d(y,_,x){if(_[x]===void 0)return typeof y=="number"||typeof y=="boolean"?_[x]=y:ArrayBuffer.isView(y)?_[x]=y.slice():_[x]=y.clone(),!0;{let T=_[x];if(typeof y=="number"||typeof y=="boolean"){if(T!==y)return _[x]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(T.equals(y)===!1)return T.copy(y),!0}}return!1}function p(y){let _=y.uniforms,x=0,T=16;for(let b=0,S=_.length;b<S;b++){let C=Array.isArray(_[b])?_[b]:[_[b]];for(let I=0,L=C.length;I<L;I++){let O=C[I],z=Array.isArray(O.value)?O.value:[O.value],U=Array.isArray(_[b])||Array.isArray(O.value),G=x;for(let H=0,le=z.length;H<le;H++){let j=z[H],te=v(j,U),ne=x%T,pe=ne%te.boundary,he=ne+pe;x+=pe,he!==0&&T-he<te.storage&&(x+=T-he),H===0&&(G=x),x+=te.storage}let q=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new q((x-G)/Float32Array.BYTES_PER_ELEMENT),O.__offset=G}}let M=x%T;return M>0&&(x+=T-M),y.__size=x,y.__cache={},this}function v(y,_){let x={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(x.boundary=4,x.storage=4):y.isVector2?(x.boundary=8,x.storage=8):y.isVector3||y.isColor?(x.boundary=16,x.storage=12):y.isVector4?(x.boundary=16,x.storage=16):y.isMatrix3?(x.boundary=16,x.storage=48):y.isMatrix4?(x.boundary=16,x.storage=64):y.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(x.boundary=16,x.storage=y.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",y),_===!0&&(x.boundary=16,x.storage=Math.ceil(x.storage/16)*16),x}function m(y){let _=y.target;_.removeEventListener("dispose",m),n.deleteBuffer(s[_.id]),delete s[_.id],delete r[_.id]}function g(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:a,update:o,dispose:g}}var V3=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ys=null;function G3(){return Ys===null&&(Ys=new xr(V3,16,16,ia,Ts),Ys.name="DFG_LUT",Ys.minFilter=Ri,Ys.magFilter=Ri,Ys.wrapS=Hs,Ys.wrapT=Hs,Ys.generateMipmaps=!1,Ys.needsUpdate=!0),Ys}var Sf=class{constructor(e={}){let{canvas:t=vb(),context:i=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=Oi}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=a;let v=d,m=new Set([zu,Bu,ku]),g=new Set([Oi,Ji,ko,Ea,Uu,Fu]),y=new Uint32Array(4),_=new Int32Array(4),x={textures:[],min:[],max:[],resolution:[]},T=null,M=null,b=[],S=[],C=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=qs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,L=!1,O=null,z=null,U=null,G=null;this._outputColorSpace=Ti;let q=0,H=0,le=null,j=-1,te=null,ne=new Bt,pe=new Bt,he=null,Q=new qe(0),fe=0,ve=t.width,Ee=t.height,be=1,Xe=null,ot=null,Ge=new Bt(0,0,ve,Ee),dt=new Bt(0,0,ve,Ee),ut=!1,Qe=new Jr,un=new au,Qt=!1,Tn=!1,Xt=new St,Xn=new P,Rt=new Bt,Fn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},yn=!1;function An(){return le===null?be:1}let B=i;function Ie(R,V){return t.getContext(R,V)}let Ke,ft,Te,Yt,We,Ze,D,E,$,de,oe,xe,_e,ie,re,ge,k,ae,se,Ae,ye,Me,$e;try{let R={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",st,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),B===null){let V="webgl2";if(B=Ie(V,R),B===null)throw Ie(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}it()}catch(R){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",st,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),rt("WebGLRenderer: "+R.message),R}function it(){Ke=new e2(B),Ke.init(),ye=new F3(B,Ke),ft=new GA(B,Ke,e,ye),Te=new N3(B,Ke),ft.reversedDepthBuffer&&f&&Te.buffers.depth.setReversed(!0),z=B.createFramebuffer(),U=B.createFramebuffer(),G=B.createFramebuffer(),Yt=new i2(B),We=new x3,Ze=new U3(B,Ke,Te,We,ft,ye,Yt),D=new QA(I),E=new rE(B),Me=new HA(B,E),$=new t2(B,E,Yt,Me),de=new r2(B,$,E,Me,Yt),ae=new s2(B,ft,Ze),re=new WA(We),oe=new b3(I,D,Ke,ft,Me,re),xe=new z3(I,We),_e=new w3,ie=new R3(Ke),k=new zA(I,D,Te,de,p,l),ge=new D3(I,de,ft),$e=new H3(B,Yt,ft,Te),se=new VA(B,Ke,Yt),Ae=new n2(B,Ke,Yt),Yt.programs=oe.programs,I.capabilities=ft,I.extensions=Ke,I.properties=We,I.renderLists=_e,I.shadowMap=ge,I.state=Te,I.info=Yt}v!==Oi&&(C=new o2(v,t.width,t.height,o,s,r));let ue=new Zm(I,B);this.xr=ue,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let R=Ke.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Ke.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return be},this.setPixelRatio=function(R){R!==void 0&&(be=R,this.setSize(ve,Ee,!1))},this.getSize=function(R){return R.set(ve,Ee)},this.setSize=function(R,V,ee=!0){if(ue.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=R,Ee=V,t.width=Math.floor(R*be),t.height=Math.floor(V*be),ee===!0&&(t.style.width=R+"px",t.style.height=V+"px"),C!==null&&C.setSize(t.width,t.height),this.setViewport(0,0,R,V)},this.getDrawingBufferSize=function(R){return R.set(ve*be,Ee*be).floor()},this.setDrawingBufferSize=function(R,V,ee){ve=R,Ee=V,be=ee,t.width=Math.floor(R*ee),t.height=Math.floor(V*ee),this.setViewport(0,0,R,V)},this.setEffects=function(R){if(v===Oi){rt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let V=0;V<R.length;V++)if(R[V].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}C.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(ne)},this.getViewport=function(R){return R.copy(Ge)},this.setViewport=function(R,V,ee,Y){R.isVector4?Ge.set(R.x,R.y,R.z,R.w):Ge.set(R,V,ee,Y),Te.viewport(ne.copy(Ge).multiplyScalar(An()).round())},this.getScissor=function(R){return R.copy(dt)},this.setScissor=function(R,V,ee,Y){R.isVector4?dt.set(R.x,R.y,R.z,R.w):dt.set(R,V,ee,Y),Te.scissor(pe.copy(dt).multiplyScalar(An()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(R){Te.setScissorTest(ut=R)},this.setOpaqueSort=function(R){Xe=R},this.setTransparentSort=function(R){ot=R},this.getClearColor=function(R){return R.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(R=!0,V=!0,ee=!0){let Y=0;if(R){let Z=!1;if(le!==null){let Re=le.texture.format;Z=m.has(Re)}if(Z){let Re=le.texture.type,De=g.has(Re),Ce=k.getClearColor(),Ne=k.getClearAlpha(),Ve=Ce.r,lt=Ce.g,xt=Ce.b;De?(y[0]=Ve,y[1]=lt,y[2]=xt,y[3]=Ne,B.clearBufferuiv(B.COLOR,0,y)):(_[0]=Ve,_[1]=lt,_[2]=xt,_[3]=Ne,B.clearBufferiv(B.COLOR,0,_))}else Y|=B.COLOR_BUFFER_BIT}V&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ee&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),O=R},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",st,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),k.dispose(),_e.dispose(),ie.dispose(),Ze.dispose(),We.dispose(),D.dispose(),de.dispose(),$.dispose(),Me.dispose(),$e.dispose(),oe.dispose(),ue.dispose(),ue.removeEventListener("sessionstart",Qc),ue.removeEventListener("sessionend",Is),ir.stop()};function ze(R){R.preventDefault(),zl("WebGLRenderer: Context Lost."),L=!0}function st(){zl("WebGLRenderer: Context Restored."),L=!1;let R=Yt.autoReset,V=ge.enabled,ee=ge.autoUpdate,Y=ge.needsUpdate,Z=ge.type;it(),Yt.autoReset=R,ge.enabled=V,ge.autoUpdate=ee,ge.needsUpdate=Y,ge.type=Z}function Pe(R){rt("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function pt(R){let V=R.target;V.removeEventListener("dispose",pt),nn(V)}function nn(R){xi(R),We.remove(R)}function xi(R){let V=We.get(R).programs;V!==void 0&&(V.forEach(function(ee){oe.releaseProgram(ee)}),R.isShaderMaterial&&oe.releaseShaderCache(R))}this.renderBufferDirect=function(R,V,ee,Y,Z,Re){V===null&&(V=Fn);let De=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ce=fl(R,V,ee,Y,Z);Te.setMaterial(Y,De);let Ne=ee.index,Ve=1;if(Y.wireframe===!0){if(Ne=$.getWireframeAttribute(ee),Ne===void 0)return;Ve=2}let lt=ee.drawRange,xt=ee.attributes.position,He=lt.start*Ve,_t=(lt.start+lt.count)*Ve;Re!==null&&(He=Math.max(He,Re.start*Ve),_t=Math.min(_t,(Re.start+Re.count)*Ve)),Ne!==null?(He=Math.max(He,0),_t=Math.min(_t,Ne.count)):xt!=null&&(He=Math.max(He,0),_t=Math.min(_t,xt.count));let mn=_t-He;if(mn<0||mn===1/0)return;Me.setup(Z,Y,Ce,ee,Ne);let Vt,Gt=se;if(Ne!==null&&(Vt=E.get(Ne),Gt=Ae,Gt.setIndex(Vt)),Z.isMesh)Y.wireframe===!0?(Te.setLineWidth(Y.wireframeLinewidth*An()),Gt.setMode(B.LINES)):Gt.setMode(B.TRIANGLES);else if(Z.isLine){let On=Y.linewidth;On===void 0&&(On=1),Te.setLineWidth(On*An()),Z.isLineSegments?Gt.setMode(B.LINES):Z.isLineLoop?Gt.setMode(B.LINE_LOOP):Gt.setMode(B.LINE_STRIP)}else Z.isPoints?Gt.setMode(B.POINTS):Z.isSprite&&Gt.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(Ke.get("WEBGL_multi_draw"))Gt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let On=Z._multiDrawStarts,Oe=Z._multiDrawCounts,Rn=Z._multiDrawCount,Mt=Ne?E.get(Ne).bytesPerElement:1,rr=We.get(Y).currentProgram.getUniforms();for(let Cn=0;Cn<Rn;Cn++)rr.setValue(B,"_gl_DrawID",Cn),Gt.render(On[Cn]/Mt,Oe[Cn])}else if(Z.isInstancedMesh)Gt.renderInstances(He,mn,Z.count);else if(ee.isInstancedBufferGeometry){let On=ee._maxInstanceCount!==void 0?ee._maxInstanceCount:1/0,Oe=Math.min(ee.instanceCount,On);Gt.renderInstances(He,mn,Oe)}else Gt.render(He,mn)};function cl(R,V,ee,Y){O!==null&&R.isNodeMaterial&&O.setObject(Y,R),Qt===!0&&re.setState(R,ee,!1),R.transparent===!0&&R.side===vn&&R.forceSinglePass===!1?(R.side=Pi,R.needsUpdate=!0,Ls(R,V,Y),R.side=$s,R.needsUpdate=!0,Ls(R,V,Y),R.side=vn):Ls(R,V,Y)}this.compile=function(R,V,ee=null){ee===null&&(ee=R),O!==null&&O.renderStart(R,V,ee),M=ie.get(ee),M.init(V),S.push(M),ee.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(M.pushLight(Z),Z.castShadow&&M.pushShadow(Z))}),R!==ee&&R.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(M.pushLight(Z),Z.castShadow&&M.pushShadow(Z))}),M.setupLights(),O!==null&&O.updateLights(M.state.lightsArray),Tn=this.localClippingEnabled,Qt=re.init(this.clippingPlanes,Tn),Qt===!0&&re.setGlobalState(this.clippingPlanes,V),O!==null&&ge.render(M.state.shadowsArray,ee,V);let Y=new Set;return R.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Re=Z.material;if(Re)if(Array.isArray(Re))for(let De=0;De<Re.length;De++){let Ce=Re[De];cl(Ce,ee,V,Z),Y.add(Ce)}else cl(Re,ee,V,Z),Y.add(Re)}),M=S.pop(),O!==null&&O.renderEnd(),Y},this.compileAsync=function(R,V,ee=null){let Y=this.compile(R,V,ee);return new Promise(Z=>{function Re(){if(Y.forEach(function(De){let Ne=We.get(De).currentProgram;(Ne===void 0||Ne.isReady())&&Y.delete(De)}),Y.size===0){Z(R);return}setTimeout(Re,10)}Ke.get("KHR_parallel_shader_compile")!==null?Re():setTimeout(Re,10)})};let Va=null;function qd(R){Va&&Va(R)}function Qc(){ir.stop()}function Is(){ir.start()}let ir=new jb;ir.setAnimationLoop(qd),typeof self<"u"&&ir.setContext(self),this.setAnimationLoop=function(R){Va=R,ue.setAnimationLoop(R),R===null?ir.stop():ir.start()},ue.addEventListener("sessionstart",Qc),ue.addEventListener("sessionend",Is),this.render=function(R,V){if(V!==void 0&&V.isCamera!==!0){rt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;O!==null&&O.renderStart(R,V);let ee=ue.enabled===!0&&ue.isPresenting===!0,Y=C!==null&&(le===null||ee)&&C.begin(I,le);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ue.enabled===!0&&ue.isPresenting===!0&&(C===null||C.isCompositing()===!1)&&(ue.cameraAutoUpdate===!0&&ue.updateCamera(V),V=ue.getCamera()),R.isScene===!0&&R.onBeforeRender(I,R,V,le),M=ie.get(R,S.length),M.init(V),M.state.textureUnits=Ze.getTextureUnits(),S.push(M),Xt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?un.setFromArrayCamera(V):Qe.setFromProjectionMatrix(Xt,ls,V.reversedDepth),Tn=this.localClippingEnabled,Qt=re.init(this.clippingPlanes,Tn),T=_e.get(R,b.length),T.init(),b.push(T),this.info.render.frame++,ue.enabled===!0&&ue.isPresenting===!0){let De=I.xr.getDepthSensingMesh();De!==null&&sr(De,V,-1/0,I.sortObjects)}sr(R,V,0,I.sortObjects),T.finish(),O!==null&&O.updateLights(M.state.lightsArray),I.sortObjects===!0&&T.sort(Xe,ot),yn=ue.enabled===!1||ue.isPresenting===!1||ue.hasDepthSensing()===!1,yn&&k.addToRenderList(T,R),this.info.autoReset===!0&&this.info.reset(),Qt===!0&&re.beginShadows();let Z=M.state.shadowsArray;if(ge.render(Z,R,V),Qt===!0&&re.endShadows(),(Y&&C.hasRenderPass())===!1){let De=T.opaque,Ce=T.transmissive;if(M.setupLights(),V.isArrayCamera){let Ne=V.cameras;if(Ce.length>0)for(let Ve=0,lt=Ne.length;Ve<lt;Ve++){let xt=Ne[Ve];ps(De,Ce,R,xt)}yn&&k.render(R);for(let Ve=0,lt=Ne.length;Ve<lt;Ve++){let xt=Ne[Ve];hl(T,R,xt,xt.viewport)}}else Ce.length>0&&ps(De,Ce,R,V),yn&&k.render(R),hl(T,R,V)}le!==null&&H===0&&(Ze.updateMultisampleRenderTarget(le),Ze.updateRenderTargetMipmap(le)),Y&&C.end(I),R.isScene===!0&&R.onAfterRender(I,R,V),Me.resetDefaultState(),j=-1,te=null,S.pop(),S.length>0?(M=S[S.length-1],Ze.setTextureUnits(M.state.textureUnits),Qt===!0&&re.setGlobalState(I.clippingPlanes,M.state.camera)):M=null,b.pop(),b.length>0?T=b[b.length-1]:T=null,O!==null&&O.renderEnd()};function sr(R,V,ee,Y){if(R.visible===!1)return;if(R.layers.test(V.layers)){if(R.isGroup)ee=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(V);else if(R.isLight)M.pushLight(R),R.castShadow&&M.pushShadow(R);else if(R.isSprite){let De=V.isArrayCamera?un:Qe;if(!R.frustumCulled||R.intersectsFrustum(De)){Y&&Rt.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Xt);let Ce=de.update(R),Ne=R.material;Ne.visible&&T.push(R,Ce,Ne,ee,Rt.z,null,V)}}else if(R.isMesh||R.isLine||R.isPoints){let De=V.isArrayCamera?un:Qe;if(!R.frustumCulled||R.intersectsFrustum(De)){let Ce=de.update(R),Ne=R.material;if(Y&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Rt.copy(R.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),Rt.copy(Ce.boundingSphere.center)),Rt.applyMatrix4(R.matrixWorld).applyMatrix4(Xt)),Array.isArray(Ne)){let Ve=Ce.groups;for(let lt=0,xt=Ve.length;lt<xt;lt++){let He=Ve[lt],_t=Ne[He.materialIndex];_t&&_t.visible&&T.push(R,Ce,_t,ee,Rt.z,He,V)}}else Ne.visible&&T.push(R,Ce,Ne,ee,Rt.z,null,V)}}}let Re=R.children;for(let De=0,Ce=Re.length;De<Ce;De++)sr(Re[De],V,ee,Y)}function hl(R,V,ee,Y){let{opaque:Z,transmissive:Re,transparent:De}=R;M.setupLightsView(ee),Qt===!0&&re.setGlobalState(I.clippingPlanes,ee),Y&&Te.viewport(ne.copy(Y)),Z.length>0&&bn(Z,V,ee),Re.length>0&&bn(Re,V,ee),De.length>0&&bn(De,V,ee),Te.buffers.depth.setTest(!0),Te.buffers.depth.setMask(!0),Te.buffers.color.setMask(!0),Te.setPolygonOffset(!1)}function ps(R,V,ee,Y){if((ee.isScene===!0?ee.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[Y.id]===void 0){let He=Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[Y.id]=new ai(1,1,{generateMipmaps:!0,type:He?Ts:Oi,minFilter:Er,samples:Math.max(4,ft.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Et.workingColorSpace})}let Re=M.state.transmissionRenderTarget[Y.id],De=Y.viewport||ne;Re.setSize(De.z*I.transmissionResolutionScale,De.w*I.transmissionResolutionScale);let Ce=I.getRenderTarget(),Ne=I.getActiveCubeFace(),Ve=I.getActiveMipmapLevel();I.setRenderTarget(Re),I.getClearColor(Q),fe=I.getClearAlpha(),fe<1&&I.setClearColor(16777215,.5),I.clear(),yn&&k.render(ee);let lt=I.toneMapping;I.toneMapping=qs;let xt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),M.setupLightsView(Y),Qt===!0&&re.setGlobalState(I.clippingPlanes,Y),bn(R,ee,Y),Ze.updateMultisampleRenderTarget(Re),Ze.updateRenderTargetMipmap(Re),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let He=!1;for(let _t=0,mn=V.length;_t<mn;_t++){let Vt=V[_t],{object:Gt,geometry:On,material:Oe,group:Rn}=Vt;if(Oe.side===vn&&Gt.layers.test(Y.layers)){let Mt=Oe.side;Oe.side=Pi,Oe.needsUpdate=!0,Sn(Gt,ee,Y,On,Oe,Rn),Oe.side=Mt,Oe.needsUpdate=!0,He=!0}}He===!0&&(Ze.updateMultisampleRenderTarget(Re),Ze.updateRenderTargetMipmap(Re))}I.setRenderTarget(Ce,Ne,Ve),I.setClearColor(Q,fe),xt!==void 0&&(Y.viewport=xt),I.toneMapping=lt}function bn(R,V,ee){let Y=V.isScene===!0?V.overrideMaterial:null;for(let Z=0,Re=R.length;Z<Re;Z++){let De=R[Z],{object:Ce,geometry:Ne,group:Ve}=De,lt=De.material;lt.allowOverride===!0&&Y!==null&&(lt=Y),Ce.layers.test(ee.layers)&&Sn(Ce,V,ee,Ne,lt,Ve)}}function Sn(R,V,ee,Y,Z,Re){O!==null&&Z.isNodeMaterial&&O.setObject(R,Z),R.onBeforeRender(I,V,ee,Y,Z,Re),R.modelViewMatrix.multiplyMatrices(ee.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Z.onBeforeRender(I,V,ee,Y,R,Re),Z.transparent===!0&&Z.side===vn&&Z.forceSinglePass===!1?(Z.side=Pi,Z.needsUpdate=!0,I.renderBufferDirect(ee,V,Y,Z,R,Re),Z.side=$s,Z.needsUpdate=!0,I.renderBufferDirect(ee,V,Y,Z,R,Re),Z.side=vn):I.renderBufferDirect(ee,V,Y,Z,R,Re),R.onAfterRender(I,V,ee,Y,Z,Re)}function Mn(R){let V=0;for(let ee of R)ee.texture!==null&&V++;return V}function Ls(R,V,ee){V.isScene!==!0&&(V=Fn);let Y=We.get(R),Z=M.state.lights,Re=M.state.shadowsArray,De=Z.state.version,Ce=oe.getParameters(R,Z.state,Re,V,ee,M.state.lightProbeGridArray),Ne=oe.getProgramCacheKey(Ce),Ve=Y.programs;Y.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?V.environment:null,Y.fog=V.fog;let lt=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Y.envMap=D.get(R.envMap||Y.environment,lt),Y.envMapRotation=Y.environment!==null&&R.envMap===null?V.environmentRotation:R.envMapRotation,Ve===void 0&&(R.addEventListener("dispose",pt),Ve=new Map,Y.programs=Ve,Y.programVariants=new Map);let xt=Ve.get(Ne);if(xt!==void 0){if(Y.currentProgram===xt&&Y.lightsStateVersion===De)return ul(R,Ce),xt}else Ce.uniforms=oe.getUniforms(R),O!==null&&R.isNodeMaterial&&O.build(R,ee,Ce),R.onBeforeCompile(Ce,I),xt=oe.acquireProgram(Ce,Ne),Ve.set(Ne,xt),Y.uniforms=Ce.uniforms;let He=Y.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(He.clippingPlanes=re.uniform),ul(R,Ce),Y.needsLights=kr(R),Y.lightsStateVersion=De,Y.needsLights&&(He.ambientLightColor.value=Z.state.ambient,He.lightProbe.value=Z.state.probe,He.sunLights.value=Z.state.sun,He.sunLightShadows.value=Z.state.sunShadow,He.directionalLights.value=Z.state.directional,He.directionalLightShadows.value=Z.state.directionalShadow,He.spotLights.value=Z.state.spot,He.spotLightShadows.value=Z.state.spotShadow,He.rectAreaLights.value=Z.state.rectArea,He.ltc_1.value=Z.state.rectAreaLTC1,He.ltc_2.value=Z.state.rectAreaLTC2,He.pointLights.value=Z.state.point,He.pointLightShadows.value=Z.state.pointShadow,He.hemisphereLights.value=Z.state.hemi,He.sunShadowMatrix.value=Z.state.sunShadowMatrix,He.sunShadowCascade.value=Z.state.sunShadowCascade,He.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,He.spotLightMatrix.value=Z.state.spotLightMatrix,He.spotLightMap.value=Z.state.spotLightMap,He.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=Mn(M.state.lightProbeGridArray),Y.currentProgram=xt,Y.uniformsList=null,xt}function Hi(R,V,ee,Y,Z){let Re=We.get(R),De=Re.currentProgram.id+","+Y+","+Z,Ce=Re.programVariants.get(De);return Ce===void 0?(Ce=Ls(R,V,ee),Re.programVariants.set(De,Ce)):(Re.currentProgram=Ce,Re.uniformsList=null,Re.outputColorSpace=Y,Re.toneMapping=Z),Ce}function Or(R){if(R.uniformsList===null){let V=R.currentProgram.getUniforms();R.uniformsList=Bo.seqWithValue(V.seq,R.uniforms)}return R.uniformsList}function ul(R,V){let ee=We.get(R);ee.outputColorSpace=V.outputColorSpace,ee.batching=V.batching,ee.batchingColor=V.batchingColor,ee.instancing=V.instancing,ee.instancingColor=V.instancingColor,ee.instancingMorph=V.instancingMorph,ee.skinning=V.skinning,ee.morphTargets=V.morphTargets,ee.morphNormals=V.morphNormals,ee.morphColors=V.morphColors,ee.morphTargetsCount=V.morphTargetsCount,ee.numClippingPlanes=V.numClippingPlanes,ee.numIntersection=V.numClipIntersection,ee.vertexAlphas=V.vertexAlphas,ee.vertexTangents=V.vertexTangents,ee.toneMapping=V.toneMapping}function fl(R,V,ee,Y,Z){V.isScene!==!0&&(V=Fn),Ze.resetTextureUnits();let Re=V.fog,De=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?V.environment:null,Ce=le===null?I.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:Et.workingColorSpace,Ne=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ve=D.get(Y.envMap||De,Ne),lt=Y.vertexColors===!0&&!!ee.attributes.color&&ee.attributes.color.itemSize===4,xt=!!ee.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),He=!!ee.morphAttributes.position,_t=!!ee.morphAttributes.normal,mn=!!ee.morphAttributes.color,Vt=qs;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Vt=I.toneMapping);let Gt=ee.morphAttributes.position||ee.morphAttributes.normal||ee.morphAttributes.color,On=Gt!==void 0?Gt.length:0,Oe=We.get(Y),Rn=M.state.lights;if(Qt===!0&&(Tn===!0||R!==te)){let Wt=R===te&&Y.id===j;re.setState(Y,R,Wt)}let Mt=!1,rr=!1;Y.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==Rn.state.version||Z.isBatchedMesh&&Oe.batching===!1||!Z.isBatchedMesh&&Oe.batching===!0||Z.isBatchedMesh&&Oe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Oe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Oe.instancing===!1||!Z.isInstancedMesh&&Oe.instancing===!0||Z.isSkinnedMesh&&Oe.skinning===!1||!Z.isSkinnedMesh&&Oe.skinning===!0||Z.isInstancedMesh&&Oe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Oe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Oe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Oe.instancingMorph===!1&&Z.morphTexture!==null||Oe.envMap!==Ve||Y.fog===!0&&Oe.fog!==Re||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==re.numPlanes||Oe.numIntersection!==re.numIntersection)||Oe.vertexAlphas!==lt||Oe.vertexTangents!==xt||Oe.morphTargets!==He||Oe.morphNormals!==_t||Oe.morphColors!==mn||Oe.morphTargetsCount!==On||Oe.numLightProbeGrids!==Mn(M.state.lightProbeGridArray)?Mt=!0:(Oe.outputColorSpace!==Ce||Oe.toneMapping!==Vt)&&(rr=!0):(Mt=!0,Oe.__version=Y.version);let Cn=Oe.currentProgram;(Mt===!0||rr===!0)&&(Cn=rr===!0?Hi(Y,V,Z,Ce,Vt):Ls(Y,V,Z),O&&Y.isNodeMaterial&&O.onUpdateProgram(Y,Cn,Oe));let Xa=!1,Ds=!1,ar=!1,gt=Cn.getUniforms(),xn=Oe.uniforms;if(Te.useProgram(Cn.program)&&(Xa=!0,Ds=!0,ar=!0),Y.id!==j&&(j=Y.id,Ds=!0),Xa||te!==R){Te.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),gt.setValue(B,"projectionMatrix",R.projectionMatrix),gt.setValue(B,"viewMatrix",R.matrixWorldInverse);let Pn=gt.map.cameraPosition;Pn!==void 0&&Pn.setValue(B,Xn.setFromMatrixPosition(R.matrixWorld)),ft.logarithmicDepthBuffer&&gt.setValue(B,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&gt.setValue(B,"isOrthographic",R.isOrthographicCamera===!0),te!==R&&(te=R,Ds=!0,ar=!0)}if(Oe.needsLights&&(Rn.state.sunShadowMap.length>0&&gt.setValue(B,"sunShadowMap",Rn.state.sunShadowMap,Ze),Rn.state.directionalShadowMap.length>0&&gt.setValue(B,"directionalShadowMap",Rn.state.directionalShadowMap,Ze),Rn.state.spotShadowMap.length>0&&gt.setValue(B,"spotShadowMap",Rn.state.spotShadowMap,Ze),Rn.state.pointShadowMap.length>0&&gt.setValue(B,"pointShadowMap",Rn.state.pointShadowMap,Ze)),Z.isSkinnedMesh){gt.setOptional(B,Z,"bindMatrix"),gt.setOptional(B,Z,"bindMatrixInverse");let Wt=Z.skeleton;Wt&&(Wt.boneTexture===null&&Wt.computeBoneTexture(),gt.setValue(B,"boneTexture",Wt.boneTexture,Ze))}Z.isBatchedMesh&&(gt.setOptional(B,Z,"batchingTexture"),gt.setValue(B,"batchingTexture",Z._matricesTexture,Ze),gt.setOptional(B,Z,"batchingIdTexture"),gt.setValue(B,"batchingIdTexture",Z._indirectTexture,Ze),gt.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&gt.setValue(B,"batchingColorTexture",Z._colorsTexture,Ze));let _i=ee.morphAttributes;if((_i.position!==void 0||_i.normal!==void 0||_i.color!==void 0)&&ae.update(Z,ee,Cn),(Ds||Oe.receiveShadow!==Z.receiveShadow)&&(Oe.receiveShadow=Z.receiveShadow,gt.setValue(B,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&V.environment!==null&&(xn.envMapIntensity.value=V.environmentIntensity),xn.dfgLUT!==void 0&&(xn.dfgLUT.value=G3()),Ds){if(gt.setValue(B,"toneMappingExposure",I.toneMappingExposure),Oe.needsLights&&Ga(xn,ar),Re&&Y.fog===!0&&xe.refreshFogUniforms(xn,Re),xe.refreshMaterialUniforms(xn,Y,be,Ee,M.state.transmissionRenderTarget[R.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Wt=x,Pn=0;for(let fi of M.state.lightProbeGridArray)fi.texture!==null&&(Wt.textures[Pn]=fi.texture,Wt.min[Pn]=fi.boundingBox.min,Wt.max[Pn]=fi.boundingBox.max,Wt.resolution[Pn]=fi.resolution,Pn++);for(let fi in Wt)Wt[fi].length=Pn;xn.probesSH.value=Wt.textures,xn.probesMin.value=Wt.min,xn.probesMax.value=Wt.max,xn.probesResolution.value=Wt.resolution}Bo.upload(B,Or(Oe),xn,Ze)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Bo.upload(B,Or(Oe),xn,Ze),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&gt.setValue(B,"center",Z.center),gt.setValue(B,"modelViewMatrix",Z.modelViewMatrix),gt.setValue(B,"normalMatrix",Z.normalMatrix),gt.setValue(B,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Wt=Y.uniformsGroups;for(let Pn=0,fi=Wt.length;Pn<fi;Pn++){let eh=Wt[Pn];$e.update(eh,Cn),$e.bind(eh,Cn)}}return Cn}function Ga(R,V){R.ambientLightColor.needsUpdate=V,R.lightProbe.needsUpdate=V,R.sunLights.needsUpdate=V,R.sunLightShadows.needsUpdate=V,R.directionalLights.needsUpdate=V,R.directionalLightShadows.needsUpdate=V,R.pointLights.needsUpdate=V,R.pointLightShadows.needsUpdate=V,R.spotLights.needsUpdate=V,R.spotLightShadows.needsUpdate=V,R.rectAreaLights.needsUpdate=V,R.hemisphereLights.needsUpdate=V}function kr(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(R,V,ee){let Y=We.get(R);Y.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),We.get(R.texture).__webglTexture=V,We.get(R.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:ee,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,V){let ee=We.get(R);ee.__webglFramebuffer=V,ee.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(R,V=0,ee=0){le=R,q=V,H=ee;let Y=null,Z=!1,Re=!1;if(R){let Ce=We.get(R);if(Ce.__useDefaultFramebuffer!==void 0){Te.bindFramebuffer(B.FRAMEBUFFER,Ce.__webglFramebuffer),ne.copy(R.viewport),pe.copy(R.scissor),he=R.scissorTest,Te.viewport(ne),Te.scissor(pe),Te.setScissorTest(he),j=-1;return}else if(Ce.__webglFramebuffer===void 0)Ze.setupRenderTarget(R);else if(Ce.__hasExternalTextures)Ze.rebindTextures(R,We.get(R.texture).__webglTexture,We.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let lt=R.depthTexture;if(Ce.__boundDepthTexture!==lt){if(lt!==null&&We.has(lt)&&(R.width!==lt.image.width||R.height!==lt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(R)}}let Ne=R.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Re=!0);let Ve=We.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Ve[V])?Y=Ve[V][ee]:Y=Ve[V],Z=!0):R.samples>0&&Ze.useMultisampledRTT(R)===!1?Y=We.get(R).__webglMultisampledFramebuffer:Array.isArray(Ve)?Y=Ve[ee]:Y=Ve,ne.copy(R.viewport),pe.copy(R.scissor),he=R.scissorTest}else ne.copy(Ge).multiplyScalar(be).floor(),pe.copy(dt).multiplyScalar(be).floor(),he=ut;if(ee!==0&&(Y=z),Te.bindFramebuffer(B.FRAMEBUFFER,Y)&&Te.drawBuffers(R,Y),Te.viewport(ne),Te.scissor(pe),Te.setScissorTest(he),Z){let Ce=We.get(R.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Ce.__webglTexture,ee)}else if(Re){let Ce=V;for(let Ne=0;Ne<R.textures.length;Ne++){let Ve=We.get(R.textures[Ne]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ne,Ve.__webglTexture,ee,Ce)}}else if(R!==null&&ee!==0){let Ce=We.get(R.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ce.__webglTexture,ee)}j=-1};function Wa(R){let V=We.get(R);return(V.__readFormat!==R.format||V.__readType!==R.type)&&(V.__readFormat=R.format,V.__readType=R.type,V.__formatReadable=ft.textureFormatReadable(R.format),V.__typeReadable=ft.textureTypeReadable(R.type)),V}this.readRenderTargetPixels=function(R,V,ee,Y,Z,Re,De,Ce=0){if(!(R&&R.isWebGLRenderTarget)){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=We.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Te.bindFramebuffer(B.FRAMEBUFFER,Ne);try{let Ve=R.textures[Ce],lt=Ve.format,xt=Ve.type;R.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ce);let He=Wa(Ve);if(He.__formatReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(He.__typeReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=R.width-Y&&ee>=0&&ee<=R.height-Z&&B.readPixels(V,ee,Y,Z,ye.convert(lt),ye.convert(xt),Re)}finally{let Ve=le!==null?We.get(le).__webglFramebuffer:null;Te.bindFramebuffer(B.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(R,V,ee,Y,Z,Re,De,Ce=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=We.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(V>=0&&V<=R.width-Y&&ee>=0&&ee<=R.height-Z){Te.bindFramebuffer(B.FRAMEBUFFER,Ne);let Ve=R.textures[Ce],lt=Ve.format,xt=Ve.type;R.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ce);let He=Wa(Ve);if(He.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(He.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,_t),B.bufferData(B.PIXEL_PACK_BUFFER,Re.byteLength,B.STREAM_READ),B.readPixels(V,ee,Y,Z,ye.convert(lt),ye.convert(xt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let mn=le!==null?We.get(le).__webglFramebuffer:null;Te.bindFramebuffer(B.FRAMEBUFFER,mn);let Vt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await bb(B,Vt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,_t),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Re),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(_t),B.deleteSync(Vt),Re}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,V=null,ee=0){let Y=Math.pow(2,-ee),Z=Math.floor(R.image.width*Y),Re=Math.floor(R.image.height*Y),De=V!==null?V.x:0,Ce=V!==null?V.y:0;Ze.setTexture2D(R,0),B.copyTexSubImage2D(B.TEXTURE_2D,ee,0,0,De,Ce,Z,Re),Te.unbindTexture()},this.copyTextureToTexture=function(R,V,ee=null,Y=null,Z=0,Re=0){let De,Ce,Ne,Ve,lt,xt,He,_t,mn,Vt=R.isCompressedTexture?R.mipmaps[Re]:R.image;if(ee!==null)De=ee.max.x-ee.min.x,Ce=ee.max.y-ee.min.y,Ne=ee.isBox3?ee.max.z-ee.min.z:1,Ve=ee.min.x,lt=ee.min.y,xt=ee.isBox3?ee.min.z:0;else{let gt=Math.pow(2,-Z);De=Math.floor(Vt.width*gt),Ce=Math.floor(Vt.height*gt),R.isDataArrayTexture?Ne=Vt.depth:R.isData3DTexture?Ne=Math.floor(Vt.depth*gt):Ne=1,Ve=0,lt=0,xt=0}Y!==null?(He=Y.x,_t=Y.y,mn=Y.z):(He=0,_t=0,mn=0);let Gt=ye.convert(V.format),On=ye.convert(V.type),Oe;V.isData3DTexture?(Ze.setTexture3D(V,0),Oe=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Ze.setTexture2DArray(V,0),Oe=B.TEXTURE_2D_ARRAY):(Ze.setTexture2D(V,0),Oe=B.TEXTURE_2D),Te.activeTexture(B.TEXTURE0),Te.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),Te.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Te.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let Rn=Te.getParameter(B.UNPACK_ROW_LENGTH),Mt=Te.getParameter(B.UNPACK_IMAGE_HEIGHT),rr=Te.getParameter(B.UNPACK_SKIP_PIXELS),Cn=Te.getParameter(B.UNPACK_SKIP_ROWS),Xa=Te.getParameter(B.UNPACK_SKIP_IMAGES);Te.pixelStorei(B.UNPACK_ROW_LENGTH,Vt.width),Te.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Vt.height),Te.pixelStorei(B.UNPACK_SKIP_PIXELS,Ve),Te.pixelStorei(B.UNPACK_SKIP_ROWS,lt),Te.pixelStorei(B.UNPACK_SKIP_IMAGES,xt);let Ds=R.isDataArrayTexture||R.isData3DTexture,ar=V.isDataArrayTexture||V.isData3DTexture;if(R.isDepthTexture){let gt=We.get(R),xn=We.get(V),_i=We.get(gt.__renderTarget),Wt=We.get(xn.__renderTarget);Te.bindFramebuffer(B.READ_FRAMEBUFFER,_i.__webglFramebuffer),Te.bindFramebuffer(B.DRAW_FRAMEBUFFER,Wt.__webglFramebuffer);for(let Pn=0;Pn<Ne;Pn++)Ds&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,We.get(R).__webglTexture,Z,xt+Pn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,We.get(V).__webglTexture,Re,mn+Pn)),B.blitFramebuffer(Ve,lt,Ve+De,lt+Ce,He,_t,He+De,_t+Ce,B.DEPTH_BUFFER_BIT,B.NEAREST);Te.bindFramebuffer(B.READ_FRAMEBUFFER,null),Te.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||R.isRenderTargetTexture||We.has(R)){let gt=We.get(R),xn=We.get(V);Te.bindFramebuffer(B.READ_FRAMEBUFFER,U),Te.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let _i=0;_i<Ne;_i++)Ds?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,gt.__webglTexture,Z,xt+_i):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,gt.__webglTexture,Z),ar?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,xn.__webglTexture,Re,mn+_i):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,xn.__webglTexture,Re),Z!==0?B.blitFramebuffer(Ve,lt,Ve+De,lt+Ce,He,_t,He+De,_t+Ce,B.COLOR_BUFFER_BIT,B.NEAREST):ar?B.copyTexSubImage3D(Oe,Re,He,_t,mn+_i,Ve,lt,De,Ce):B.copyTexSubImage2D(Oe,Re,He,_t,Ve,lt,De,Ce);Te.bindFramebuffer(B.READ_FRAMEBUFFER,null),Te.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else ar?R.isDataTexture||R.isData3DTexture?B.texSubImage3D(Oe,Re,He,_t,mn,De,Ce,Ne,Gt,On,Vt.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Oe,Re,He,_t,mn,De,Ce,Ne,Gt,Vt.data):B.texSubImage3D(Oe,Re,He,_t,mn,De,Ce,Ne,Gt,On,Vt):R.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Re,He,_t,De,Ce,Gt,On,Vt.data):R.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Re,He,_t,Vt.width,Vt.height,Gt,Vt.data):B.texSubImage2D(B.TEXTURE_2D,Re,He,_t,De,Ce,Gt,On,Vt);Te.pixelStorei(B.UNPACK_ROW_LENGTH,Rn),Te.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Mt),Te.pixelStorei(B.UNPACK_SKIP_PIXELS,rr),Te.pixelStorei(B.UNPACK_SKIP_ROWS,Cn),Te.pixelStorei(B.UNPACK_SKIP_IMAGES,Xa),Re===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Oe),Te.unbindTexture()},this.initRenderTarget=function(R){We.get(R).__webglFramebuffer===void 0&&Ze.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Ze.setTextureCube(R,0):R.isData3DTexture?Ze.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Ze.setTexture2DArray(R,0):Ze.setTexture2D(R,0),Te.unbindTexture()},this.resetState=function(){q=0,H=0,le=null,Te.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ls}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Et._getDrawingBufferColorSpace(e),t.unpackColorSpace=Et._getUnpackColorSpace()}};var Aa={light:n=>Sp(.12+.88*n),viridis:qv,cividis:Xv,magma:Yv,turbo:$v,"blue-red":n=>Wv(1-n)},Pr=new Set(["block","material","level","held","surface","removable_type","removable_mode"]),W3={removable_type:["#a8adb3","#d62728","#f2a33a","#59a14f","#6f9bd1"],removable_mode:["#a8adb3","#59a14f","#f2a33a","#e0662b","#a3123a"]},lx=["#c3ac87","#86a3bd","#b98474","#93ab7d","#a091b5","#cda552","#76aca4","#bd93a8","#a3a39a","#d2bfa6"],Ho=16,X3=.15,Rf="#b3b1ab",$3=/\.(x|y|z)$|^rotation$|^spin$|pressure|sigma/;function Cf(n){return $3.test(n)?"blue-red":"light"}var ki=256,q3=[128,128,128],Tf=document.createElement("canvas").getContext("2d",{willReadFrequently:!0});function Jm(n){Tf.fillStyle="#000",Tf.fillStyle=n,Tf.fillRect(0,0,1,1);let[e,t,i]=Tf.getImageData(0,0,1,1).data;return[e,t,i]}function Cr(n,e=""){if(e==="material")return lx[(Math.round(n)%10+10)%10];let t=W3[e];return t?t[Math.round(n)]??t[0]:Gv[(Math.round(n)%10+10)%10]}function ax(n){let e=Math.imul(n^739982445,2246822507);return e=Math.imul(e^e>>>13,3266489909),(e^e>>>16)>>>0&Ho-1}function ox(n,e){let t=X3*(2*e/(Ho-1)-1);return Jm(n).map(i=>Math.round(t>0?i+t*(255-i):i*(1+t)))}var Af=class{texture;low=0;high=1;log=!1;kinds=!1;field="";data=new Uint8Array(8*ki);constructor(){this.texture=new xr(this.data,2*ki,1),this.texture.colorSpace=Ti,this.texture.magFilter=en,this.texture.minFilter=en,this.paint("light")}paint(e){let t=Aa[e]??Sp;this.fill(i=>this.toned?ox(Cr(Math.floor(i/Ho),"material"),i%Ho):Jm(this.kinds?Cr(i%250,this.field):t(i/(ki-1))))}plain(){this.fill(e=>ox(lx[0],e%Ho))}fill(e){for(let t=0;t<2*ki;t++)this.data.set([...t<ki?e(t):q3,255],4*t);this.data.set([...Jm(Rf),255],4*(2*ki-1)),this.texture.needsUpdate=!0}get toned(){return this.kinds&&this.field==="material"}get terrain(){return 1-.25/ki}tone(e){return(ax(e)+.5)/(2*ki)}share(e){return this.log?e>0?Math.log(e/this.low)/Math.log(this.high/this.low):-1/0:(e-this.low)/(this.high-this.low)}isBeyond(e){let t=1/(ki-1);return this.share(e)<-t||this.share(e)>1+t}place(e,t){if(!Number.isFinite(e))return .75;if(this.toned)return(Ho*((Math.round(e)%10+10)%10)+ax(t)+.5)/(2*ki);if(this.kinds)return((Math.round(e)%250+250)%250+.5)/(2*ki);let i=this.share(e);return i>0?i>1&&(i=1):i=0,(i*(ki-1)+.5)/(2*ki)}css(e){let t=4*Math.round(Math.min(1,Math.max(0,e))*(ki-1));return`rgb(${this.data[t]}, ${this.data[t+1]}, ${this.data[t+2]})`}};var cx=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"\xB5"],[1e-9,"n"]],Y3=new Set(["m","m/s","m/s2","Pa","N","N/m","J","J/m","s","W"]);function Km(n,e){if(e==="-"||e==="")return{factor:1,unit:""};if(!Y3.has(e)||!(n>0)||!Number.isFinite(n))return{factor:1,unit:e};let t=cx.find(([i])=>n>=i*.9995)??cx.at(-1);return e.startsWith("m")&&t[0]>1?{factor:1,unit:e}:{factor:1/t[0],unit:t[1]+e}}function qt(n,e=4){if(Number.isNaN(n))return"no number";if(!Number.isFinite(n))return n>0?"\u221E":"-\u221E";if(n===0)return"0";let t=Math.abs(n);if(t>=1e5||t<1e-4){let[i,s]=n.toExponential(Math.max(0,e-2)).split("e");return`${Number(i)}e${Number(s)}`}return String(Number(n.toPrecision(e)))}function pn(n,e,t=4){let i=Km(Math.abs(n),e);return i.unit?`${qt(n*i.factor,t)} ${i.unit}`:qt(n*i.factor,t)}function hx(n,e,t=5){if(!(e>n))return[n];let i=(e-n)/t,s=10**Math.floor(Math.log10(i)),r=[1,2,5,10].map(o=>o*s).find(o=>o>=i*.999)??10*s,a=[];for(let o=Math.ceil(n/r-1e-9);o*r<=e+1e-9*r;o++)a.push(o*r);return a}var j3=1e-7,Z3=new P(17e-10,29e-10,23e-10);function ux(n,e,t){let i=[],s=n.dimension===3?J3(n,e,t):null;for(let r=0;r<n.count;r++){let a=s?s(r):K3(n,r,e,t);for(let o=0;o+1<a.length;o+=2){let[l,c]=[Math.max(0,a[o]),Math.min(1,a[o+1])];c-l>j3&&i.push({from:l,to:c,block:r})}}return i.sort((r,a)=>r.from-a.from||r.to-a.to)}function J3({positions:n,corners:e,facesOf:t,faceEnds:i},s,r){let a=new P().subVectors(r,s),o=a.length(),l=new P().copy(s).addScaledVector(Z3,o);a.divideScalar(o);let c=new P(1,0,0);Math.abs(a.x)>.6&&c.set(0,1,0);let h=new P().crossVectors(a,c).normalize(),u=new P().crossVectors(a,h),[f,d,p]=[[],[],[]];return v=>{let m=[];for(let g=t[v];g<t[v+1];g++){let[y,_]=[i[g],i[g+1]-i[g]],[x,T,M,b]=[!1,!1,!1,!1];for(let C=0;C<_;C++){let I=3*e[y+C],[L,O,z]=[n[I]-l.x,n[I+1]-l.y,n[I+2]-l.z];f[C]=L*h.x+O*h.y+z*h.z,d[C]=L*u.x+O*u.y+z*u.z,p[C]=L*a.x+O*a.y+z*a.z,f[C]>=0&&(T=!0),f[C]<=0&&(x=!0),d[C]>=0&&(b=!0),d[C]<=0&&(M=!0)}if(!x||!T||!M||!b)continue;let S=(C,I)=>f[C]*d[I]-d[C]*f[I];for(let C=1;C+1<_;C++){let[I,L,O]=[S(C,C+1),S(C+1,0),S(0,C)],z=I+L+O;z===0||!(I>=0&&L>=0&&O>=0||I<=0&&L<=0&&O<=0)||m.push((I*p[0]+L*p[C]+O*p[C+1])/(z*o))}}return m.sort((g,y)=>g-y)}}function K3({positions:n,corners:e,facesOf:t,faceEnds:i},s,r,a){let o=[],[l,c]=[a.x-r.x,a.y-r.y];for(let h=t[s];h<t[s+1];h++){let[u,f]=[i[h],i[h+1]];for(let d=u;d<f;d++){let[p,v]=[3*e[d],3*e[d+1<f?d+1:u]],m=M=>l*(n[M+1]-r.y)-c*(n[M]-r.x),[g,y]=[m(p),m(v)];if(g>=0==y>=0)continue;let _=g/(g-y),[x,T]=[n[p]+_*(n[v]-n[p]),n[p+1]+_*(n[v+1]-n[p+1])];o.push(((x-r.x)*l+(T-r.y)*c)/(l*l+c*c))}}return o.sort((h,u)=>h-u)}var Pf=class{object=new Zt;line;ends;constructor(){let e={color:Qm,depthTest:!1,transparent:!0};this.line=new Co(new vt,new Ui(e)),this.ends=new wr(new vt,new Ws({...e,size:9,sizeAttenuation:!1}));for(let t of[this.line,this.ends])t.frustumCulled=!1,t.renderOrder=6,this.object.add(t);this.object.visible=!1}draw(e,t){this.object.visible=e.length>0;let i=e.flatMap(s=>[s.x,s.y,t?.6:s.z]);for(let s of[this.line,this.ends])s.geometry.dispose(),s.geometry.setAttribute("position",new tt(i,3))}},Qm="#e0007a";var fx=new WeakMap;function Q3(n){let e=fx.get(n);if(!e){e=new Map;let{twins:t,blockOf:i,count:s}=n;for(let r=0;r<t.length;r+=2){let a=i[t[r]],o=i[t[r+1]];e.set(Math.min(a,o)*s+Math.max(a,o),r)}fx.set(n,e)}return e}function If(n,e){let t=Q3(n),{twins:i,faceEnds:s,corners:r,positions:a,count:o}=n,l=[],c=[];return e.forEach(([h,u],f)=>{let d=t.get(Math.min(h,u)*o+Math.max(h,u));if(d===void 0)return;let p=i[d],v=s[p],m=s[p+1];for(let g=v+1;g+1<m;g++){for(let y of[r[v],r[g],r[g+1]])l.push(a[3*y],a[3*y+1],a[3*y+2]);c.push(f)}}),{points:l,pair:c}}var eg=4e3,Ir=[{name:"touching",colour:"#4b8fd6"},{name:"sliding",colour:"#f0a020"},{name:"softened",colour:"#3aa88f"},{name:"broken",colour:"#e0483e"},{name:"broken in tension",colour:"#d62728"},{name:"broken in shear",colour:"#2c4fb8"},{name:"broken and open",colour:"#b05cd0"},{name:"open",colour:"#c062a8"}],Uf=2;function eR(n){if(n){let r=new Io;return r.moveTo(0,-.025).lineTo(.7,-.025).lineTo(.7,-.1).lineTo(1,0),r.lineTo(.7,.1).lineTo(.7,.025).lineTo(0,.025).closePath(),new ac(r)}let e=new Sr(.025,.025,.7,5).translate(0,.35,0),t=new jl(.09,.3,8).translate(0,.85,0),i=new vt,s=[e.toNonIndexed(),t.toNonIndexed()];for(let r of["position","normal"]){let a=s.map(l=>l.getAttribute(r).array),o=new Float32Array(a[0].length+a[1].length);o.set(a[0]),o.set(a[1],a[0].length),i.setAttribute(r,new ln(o,3))}return i.rotateZ(-Math.PI/2)}var Wo=new P(1,0,0),sa=class{constructor(e,t={}){this.flat=e;this.material=new oi({side:vn,...t})}flat;object=new Zt;mesh=null;material;set colour(e){this.material.color.set(e)}draw(e,t,i,s){this.clear();let r=t.length/3,a=[];for(let f=0;f<r;f++)Math.hypot(t[3*f],t[3*f+1],t[3*f+2])>i*.01&&Number.isFinite(e[3*f])&&a.push(f);let o=Math.max(1,Math.ceil(a.length/eg)),l=a.filter((f,d)=>d%o===0),c=new _r(eR(this.flat),this.material,l.length),h=new dn,u=new P;l.forEach((f,d)=>{u.fromArray(t,3*f);let p=u.length();h.position.fromArray(e,3*f),this.flat&&(h.position.z+=.5),h.quaternion.setFromUnitVectors(Wo,u.divideScalar(p));let v=p/i*s,m=Math.max(v,s/3);h.scale.set(v,m,m),h.updateMatrix(),c.setMatrixAt(d,h.matrix)}),c.frustumCulled=!1,c.renderOrder=3,this.mesh=c,this.object.add(c)}clear(){this.mesh&&(this.object.remove(this.mesh),this.mesh.geometry.dispose(),this.mesh.dispose(),this.mesh=null)}},Vo=class{object=new Zt;geometry=new vt;points;cracks;constructor(e){this.points=new wr(this.geometry,new Ws({size:e?6:5,sizeAttenuation:!1,vertexColors:!0,depthTest:!e})),this.cracks=new zt(new vt,new Xs({vertexColors:!0,side:vn,flatShading:!0}));for(let t of[this.points,this.cracks])t.frustumCulled=!1,this.object.add(t);this.points.renderOrder=2,this.clear()}clear(){this.points.visible=!1,this.cracks.visible=!1}end(e){for(let t of[this.points,this.cracks])t.material.clippingPlanes=e}static count(e){let t=Ir.map(()=>0);for(let i of e.u8("states"))t[i]=(t[i]??0)+1;return t}drawPoints(e,t,i){let s=e.u8("states"),r=Ir.map(l=>new qe(l.colour)),a=[],o=[];s.forEach((l,c)=>{i[l]&&(a.push(t[3*c],t[3*c+1],t[3*c+2]),o.push(...r[l].toArray()))}),this.geometry.dispose(),this.geometry.setAttribute("position",new tt(a,3)),this.geometry.setAttribute("color",new tt(o,3)),this.points.visible=a.length>0}drawCracks(e,t,i,s){let r=e.u8("states"),a=e.u32("blockA"),o=e.u32("blockB"),l=[],c=[];r.forEach((v,m)=>{let[g,y]=[a[m]??Ic,o[m]??Ic],_=t!==null&&(v===4||v===5);v<Uf||_||g===Ic||y===Ic||!i.isShown(g)||!i.isShown(y)||(l.push([g,y]),c.push(v))});let{points:h,pair:u}=If(i,l),f=u.map(v=>c[v]);t&&rR(t,i,s,h,f);let d=Ir.map(v=>new qe(v.colour)),p=new Float32Array(h.length);f.forEach((v,m)=>{for(let g=0;g<3;g++)d[v].toArray(p,9*m+3*g)}),this.cracks.geometry.dispose(),this.cracks.geometry.setAttribute("position",new tt(h,3)),this.cracks.geometry.setAttribute("color",new ln(p,3)),this.cracks.visible=h.length>0}hide(e){this[e].visible=!1}},Go=class{mesh=null;object=new Zt;material=new oi({depthTest:!1,transparent:!0});clear(){this.mesh&&(this.object.remove(this.mesh),this.mesh.geometry.dispose(),this.mesh.dispose(),this.mesh=null)}},Lf=class extends Go{draw(e,t,i,s){this.clear();let r=e.f32("points"),a=e.f32("forces"),o=e.u8("states"),l=[e.u32("blockA"),e.u32("blockB")],c=Math.max(Math.abs(e.info.largest??0),Math.abs(e.info.smallest??0))||1,h=new _r(new Sr(.5,.5,1,6).rotateZ(-Math.PI/2),this.material,a.length),u=new dn,[f,d,p]=[new P,new P,new P],v=new qe;a.forEach((m,g)=>{[f,d].forEach((x,T)=>{let M=l[T][g];x.fromArray(r,6*g+3*T),M<t.count&&x.add(i(M,p))}),p.subVectors(d,f);let y=p.length();u.position.addVectors(f,d).multiplyScalar(.5),y>0&&u.quaternion.setFromUnitVectors(Wo,p.divideScalar(y));let _=o[g]===iR;u.scale.set(y,_?s/3:s,_?s/3:s),u.updateMatrix(),h.setMatrixAt(g,u.matrix),h.setColorAt(g,_?v.set("#444444"):sR(m/c,v))}),h.frustumCulled=!1,h.renderOrder=4,this.mesh=h,this.object.add(h)}},tR=.02,nR=3,Df=class extends Go{draw(e,t,i,s,r){this.clear();let a=e.f32("forces"),o=[e.u32("blockA"),e.u32("blockB")],l=e.info.longest??0,c=[],h=0;for(let v=0;3*v<a.length;v++){let m=Math.hypot(a[3*v],a[3*v+1],a[3*v+2])/l;if(!(m>tR)||!Number.isFinite(t[3*v]))continue;let g=new P().fromArray(t,3*v),y=o.map(T=>T[v]??Ic),_=y.map(s),x=y.flatMap((T,M)=>_[M]>nR*_[1-M]?[]:i(T)??[]);c.push(...x.map(T=>({from:g,to:T,share:m}))),h+=x.length>0?1:0}let u=new _r(new Sr(.5,.5,1,8).rotateZ(-Math.PI/2),this.material,c.length),f=new dn,d=new P,p=new qe;return c.sort((v,m)=>v.share-m.share).forEach(({from:v,to:m,share:g},y)=>{d.subVectors(m,v);let _=d.length();f.position.addVectors(v,m).multiplyScalar(.5),_>0&&f.quaternion.setFromUnitVectors(Wo,d.divideScalar(_)),f.scale.set(_,r*g,r*g),f.updateMatrix(),u.setMatrixAt(y,f.matrix),u.setColorAt(y,p.set("#f7c873").lerp(new qe(tg),g))}),u.frustumCulled=!1,u.renderOrder=4,this.mesh=u,this.object.add(u),h}},tg="#8c1313",ng="#ff7a00",Nf=class{object=new Zt;material=new oi({color:ng,depthTest:!1,transparent:!0,opacity:.85});build(e,t,i){for(let s of e){let r=(s.centre?[s.centre]:s.line??[]).map(a=>new P(a[0]-t[0],a[1]-t[1],a[2]-t[2]));for(let a of r)this.add(new sc(i)).position.copy(a);for(let a=0;a+1<r.length;a++){let o=r[a+1].clone().sub(r[a]),l=this.add(new Sr(i/5,i/5,o.length(),6).rotateZ(-Math.PI/2));l.position.copy(r[a]).addScaledVector(o,.5),l.quaternion.setFromUnitVectors(Wo,o.normalize())}}}add(e){let t=new zt(e,this.material);return t.renderOrder=4,this.object.add(t),t}},Lc="#1d5fd0",Dc="#d01c1c",iR=3;function sR(n,e){let t=Math.min(1,Math.abs(n));return e.set("#f4f0ea").lerp(new qe(n<0?Lc:Dc),t)}var Ic=4294967295;function rR(n,e,t,i,s){let r=n.f32("points"),a=[n.u32("blockA"),n.u32("blockB")],[o,l]=[new P,new P];n.u8("states").forEach((c,h)=>{let u=a.map(f=>f[h]).filter(f=>f<e.count);if(u.some(f=>e.isShown(f))){l.set(0,0,0);for(let f of u)l.addScaledVector(t(f,o),1/u.length);for(let f=0;f<9;f++)i.push(r[9*h+f]+l.getComponent(f%3));s.push(c)}})}function dx(n,e,t){let i=n.f32("points").slice(),s=n.u32("blockA"),r=new P;for(let a=0;a<s.length;a++){let o=s[a];o>=e.count||(t(o,r),i[3*a]=i[3*a]+r.x,i[3*a+1]=i[3*a+1]+r.y,i[3*a+2]=i[3*a+2]+r.z)}return i}var Ra=class{object;constructor(e="#ff2e88",t=5){this.object=new Ss(new vt,new Ui({color:e,depthTest:!1,transparent:!0})),this.object.renderOrder=t,this.object.frustumCulled=!1,this.object.visible=!1}draw(e){this.object.visible=e!==null,e&&(this.object.geometry.dispose(),this.object.geometry.setAttribute("position",new ln(e,3)))}};var aR=2e4;function px(n){let e=new tn;if(n.count===0)return e;let t=Math.max(1,Math.floor(n.count/aR)),i=[0,1,2].map(v=>{let m=new Float32Array(Math.ceil(n.count/t));for(let _=0;_<m.length;_++){let x=n.positions[3*n.offsets[_*t]+v];m[_]=Number.isFinite(x)?x:m[_-1]??0}m.sort();let g=_=>m[Math.round(_*(m.length-1))]??0,y=Math.max(.15*(g(.9975)-g(.0025)),n.size);return[g(.0025)-y,g(.9975)+y]}),{positions:s,offsets:r}=n,[[a,o],[l,c],[h,u]]=i,f=v=>{let[m,g,y]=[s[3*v],s[3*v+1],s[3*v+2]];return m>=a&&m<=o&&g>=l&&g<=c&&y>=h&&y<=u},d=[1/0,1/0,1/0],p=[-1/0,-1/0,-1/0];for(let v=0;v<n.count;v++){let[m,g]=[r[v],r[v+1]],y=m;for(;y<g&&!f(y);)y++;if(y!==g)for(let _=3*m;_<3*g;_++){let x=s[_],T=(_-3*m)%3;x<d[T]&&(d[T]=x),x>p[T]&&(p[T]=x)}}return p[0]>=d[0]&&e.set(new P(...d),new P(...p)),e}function mx(n,e,t,i){let{rest:s,positions:r,offsets:a,middles:o}=n;for(let l=0;l<n.count;l++){let c=Math.cos(t[l])-1,h=Math.sin(t[l]),u=e[2*l],f=e[2*l+1],d=o[3*l],p=o[3*l+1];for(let v=3*a[l];v<3*a[l+1];v+=3){let m=s[v]-d,g=s[v+1]-p;r[v]=s[v]+i*(u+c*m-h*g),r[v+1]=s[v+1]+i*(f+h*m+c*g)}}}function gx(n,e,t,i,s){let{rest:r,positions:a,offsets:o,middles:l}=n;for(let c=0;c<n.count;c++){let h=3*c,u=e[h],f=e[h+1],d=e[h+2],p=t[h]*i,v=t[h+1]*i,m=t[h+2]*i,g=p===0&&v===0&&m===0,y=Math.sqrt(Math.max(0,1-p*p-v*v-m*m)),_=l[h],x=l[h+1],T=l[h+2];for(let M=3*o[c];M<3*o[c+1];M+=3){let b=u,S=f,C=d;if(!g){let I=r[M]-_,L=r[M+1]-x,O=r[M+2]-T,z=2*(v*O-m*L),U=2*(m*I-p*O),G=2*(p*L-v*I);b+=y*z+v*G-m*U,S+=y*U+m*z-p*G,C+=y*G+p*U-v*z}a[M]=r[M]+s*b,a[M+1]=r[M+1]+s*S,a[M+2]=r[M+2]+s*C}}}function vx(n,e){let[t,i]=[n,e].map(Kn.degToRad);return[Math.sin(t)*Math.sin(i),Math.sin(t)*Math.cos(i),Math.cos(t)]}function yx(n){let e=Kn.degToRad(n);return[-Math.sin(e),Math.cos(e),0]}function bx(n,e,t,i){let{positions:s,offsets:r,count:a}=n,[o,l,c]=e.normal.map(u=>e.keep*u),h=e.keep*e.at;for(let u=0;u<a;u++){let f=1/0,d=-1/0;for(let p=3*r[u];p<3*r[u+1];p+=3){let v=o*s[p]+l*s[p+1]+c*s[p+2]-h;v<f&&(f=v),v>d&&(d=v)}i[u]=d<=t?0:f>=-t?1:2}}var oR=2**26;function xx(n,e,t){let i={triangles:[],owners:[],lines:[]},s=new P(...e.normal).multiplyScalar(e.keep),r=e.keep*e.at,a=uR(s);for(let o of t){let l=new Map;for(let c=n.facesOf[o];c<n.facesOf[o+1];c++){let h=lR(n,c,s,r);if(!(h.length<2)){h.length>2&&cR(h);for(let u=0;u+1<h.length;u+=2){let[f,d]=[h[u],h[u+1]];n.dimension===2&&i.lines.push(...f.point.toArray(),...d.point.toArray());let[p,v]=f.up?[f,d]:[d,f];l.set(p.edge,{to:v.edge,point:p.point})}}}n.dimension===3&&fR(hR(l),a,o,i)}return i}function lR(n,e,t,i){let{corners:s,faceEnds:r,positions:a}=n,o=r[e],l=r[e+1],c=d=>t.x*a[3*d]+t.y*a[3*d+1]+t.z*a[3*d+2]-i,h=[],u=s[l-1],f=c(u);for(let d=o;d<l;d++){let p=s[d],v=c(p);if(f>=0!=v>=0){let[m,g,y,_]=u<p?[u,p,f,v]:[p,u,v,f],x=y/(y-_),T=new P;for(let M of[0,1,2]){let b=a[3*m+M];T.setComponent(M,b+x*(a[3*g+M]-b))}h.push({edge:m*oR+g,up:v>=0,point:T})}u=p,f=v}return h}function cR(n){let e=n[0].point,i=n.reduce((s,r)=>r.point.distanceToSquared(e)>s.point.distanceToSquared(e)?r:s).point.clone().sub(e);n.sort((s,r)=>s.point.dot(i)-r.point.dot(i))}function hR(n){let e=[];for(let t of n.keys()){let i=[],s=t;for(let r=n.get(s);r;r=n.get(s))i.push(r.point),n.delete(s),s=r.to;s===t&&i.length>2&&e.push(i)}return e}function uR(n){let t=(Math.abs(n.z)<.9?new P(0,0,1):new P(1,0,0)).cross(n).normalize();return[t,t.clone().cross(n)]}function fR(n,[e,t],i,s){let r=n.map(h=>({points:h,flat:h.map(u=>new Se(u.dot(e),u.dot(t)))}));for(let{points:h}of r)h.forEach((u,f)=>s.lines.push(...u.toArray(),...h[(f+1)%h.length].toArray()));let a=(h,u,f)=>{s.triangles.push(h.x,h.y,h.z,u.x,u.y,u.z,f.x,f.y,f.z),s.owners.push(i)},o=r[0];if(o&&r.length===1&&dR(o.flat)){let{points:h}=o;for(let u=1;u+1<h.length;u++)a(h[0],h[u],h[u+1]);return}let l=r.filter(h=>Vs.area(h.flat)>0),c=r.filter(h=>Vs.area(h.flat)<0);for(let h of l){let u=l.length===1?c:c.filter(d=>pR(d.flat[0],h.flat)),f=[...h.points,...u.flatMap(d=>d.points)];for(let[d,p,v]of Vs.triangulateShape(h.flat.slice(),u.map(m=>m.flat.slice())))a(f[d],f[p],f[v])}}function dR(n){let e=n.length;for(let t=0;t<e;t++){let[i,s,r]=[n[t],n[(t+1)%e],n[(t+2)%e]],[a,o,l,c]=[s.x-i.x,s.y-i.y,r.x-s.x,r.y-s.y];if(a*c-o*l<-1e-6*Math.hypot(a,o)*Math.hypot(l,c))return!1}return!0}function pR(n,e){let t=!1;return e.forEach((i,s)=>{let r=e[(s+1)%e.length];i.y>n.y!=r.y>n.y&&n.x<i.x+(n.y-i.y)/(r.y-i.y)*(r.x-i.x)&&(t=!t)}),t}var Ff=class{object=new Zt;cast;mesh;lines;owners=[];withEdges=!1;constructor(e){let t={map:e,side:vn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1};this.mesh=new zt(new vt,new oi(t)),this.lines=new Ss(new vt,new Ui({color:0,transparent:!0,opacity:.55})),this.cast=new zt(this.mesh.geometry,new oi({colorWrite:!1,side:vn})),this.cast.frustumCulled=!1;for(let i of[this.mesh,this.lines])i.frustumCulled=!1,this.object.add(i);this.clear()}get count(){return new Set(this.owners).size}clear(){this.object.visible=!1,this.cast.visible=!1,this.owners=[]}draw(e,t,i){let{triangles:s,owners:r,lines:a}=e;this.owners=r,this.object.visible=a.length>0,this.withEdges=i,this.mesh.visible=s.length>0,this.cast.visible=this.mesh.visible;let o=new Float32Array(6*r.length);r.forEach((l,c)=>{for(let h=0;h<3;h++)o[6*c+2*h]=t[l]}),this.mesh.geometry.dispose(),this.mesh.geometry.setAttribute("position",new tt(s,3)),this.mesh.geometry.setAttribute("uv",new ln(o,2)),this.mesh.geometry.boundingSphere=null,this.lines.geometry.dispose(),this.lines.geometry.setAttribute("position",new tt(a,3))}fade(e){this.lines.visible=this.withEdges&&e>0,this.lines.material.opacity=.55*e}pick(e){if(!this.object.visible||!this.mesh.visible)return null;let t=e.intersectObject(this.mesh,!1)[0],i=t?.faceIndex===void 0||t.faceIndex===null?void 0:this.owners[t.faceIndex];return t&&i!==void 0?{block:i,distance:t.distance}:null}set glass(e){let{material:t}=this.mesh;t.transparent=e,t.opacity=e?.14:1,t.depthWrite=!e,t.needsUpdate=!0}dispose(){for(let e of[this.mesh,this.lines])e.geometry.dispose(),e.material.dispose()}};var Of=class{constructor(e,t){this.of=e;this.survey=t}of;survey;kept=new Map;turned=new Map;scratch=new Int32Array(64);at(e){let{faceEnds:t,facesOf:i}=this.of,s=t[i[e+1]]-t[i[e]];if(s<=64)return this.fill(e,s,this.scratch);let r=this.kept.get(e);if(r)return r;let a=this.fill(e,s,new Int32Array(s));return this.kept.set(e,a),a}fill(e,t,i){let{facesOf:s,faceEnds:r,corners:a}=this.of,[o,l]=[s[e],s[e+1]],c=r[o],h=this.survey(e)?.766:.98,u=new Float32Array(3*(l-o));for(let m=o;m<l;m++)this.normal(m,u,3*(m-o));i.fill(-1,0,t);let f=(m,g,y,_)=>{let[x,T]=[3*(g-o),3*(_-o)],b=u[x]*u[T]+u[x+1]*u[T+1]+u[x+2]*u[T+2]<h?1:0;i[m-c]=2*_+b,i[y-c]=2*g+b},{turned:d}=this,p=t>64,v=p?a.subarray(c,c+t).reduce((m,g)=>Math.min(m,g),4294967295):0;d.clear();for(let m=o;m<l;m++){let[g,y]=[r[m],r[m+1]];for(let _=g;_<y;_++){let[x,T]=[a[_],a[_+1<y?_+1:g]];if(p){let M=d.get((T-v)*4194304+(x-v));M!==void 0?f(_,m,M,this.faceOf(M,o,l)):d.set((x-v)*4194304+(T-v),_);continue}for(let M=o;M<m&&i[_-c]===-1;M++){let[b,S]=[r[M],r[M+1]];for(let C=b;C<S;C++)if(a[C]===T&&a[C+1<S?C+1:b]===x){f(_,m,C,M);break}}}}return i}faceOf(e,t,i){let{faceEnds:s}=this.of,[r,a]=[t,i];for(;r+1<a;){let o=r+a>>1;s[o]<=e?r=o:a=o}return r}normal(e,t,i){let{faceEnds:s,corners:r,rest:a}=this.of,[o,l]=[s[e],s[e+1]],c=3*r[o],[h,u,f]=[0,0,0];for(let p=o+1;p+1<l;p++){let[v,m]=[3*r[p],3*r[p+1]],[g,y,_]=[a[v]-a[c],a[v+1]-a[c+1],a[v+2]-a[c+2]],[x,T,M]=[a[m]-a[c],a[m+1]-a[c+1],a[m+2]-a[c+2]];h+=y*M-_*T,u+=_*x-g*M,f+=g*T-y*x}let d=Math.hypot(h,u,f)||1;t[i]=h/d,t[i+1]=u/d,t[i+2]=f/d}};var mR=new Zi(-1,1,1,-1,0,1),ig=class extends vt{constructor(){super(),this.setAttribute("position",new tt([-1,3,0,-1,-1,0,3,-1,0],3)),this.setAttribute("uv",new tt([0,2,0,0,2,0],2))}},gR=new ig,kf=class{constructor(e){this._mesh=new zt(gR,e)}dispose(){this._mesh.geometry.dispose()}render(e){e.render(this._mesh,mR)}get material(){return this._mesh.material}set material(e){this._mesh.material=e}};var vR=2,yR=3,bR=2048,xR=1024,_R="varying vec2 place; void main() { place = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",wR=`
  uniform sampler2D depth;
  uniform sampler2D sun;
  uniform mat4 back;
  uniform mat4 toSun;
  uniform vec2 points;
  uniform vec2 clip;
  uniform float reach;
  uniform float scale;
  uniform float lift;
  uniform float sunPoint;
  uniform float bias;
  varying vec2 place;

  vec3 at(vec2 uv) {
    vec4 p = back * vec4(2.0 * uv - 1.0, 2.0 * texture2D(depth, uv).r - 1.0, 1.0);
    return p.xyz / p.w;
  }

  void main() {
    if (texture2D(depth, place).r >= 1.0) {
      gl_FragColor = vec4(1.0);
      return;
    }
    vec2 one = 1.0 / points;
    vec3 p = at(place);
    // Of the neighbours on either side, the one on the same face is nearer in depth.
    vec3 l = p - at(place - vec2(one.x, 0.0));
    vec3 r = at(place + vec2(one.x, 0.0)) - p;
    vec3 d = p - at(place - vec2(0.0, one.y));
    vec3 u = at(place + vec2(0.0, one.y)) - p;
    vec3 n = normalize(cross(abs(l.z) < abs(r.z) ? l : r, abs(d.z) < abs(u.z) ? d : u));
    // Sixteen turns of the samples in a square of four points, which is what the smoothing covers.
    vec2 cell = mod(floor(gl_FragCoord.xy), 4.0);
    float turn = 6.2832 * fract(0.0625 * (cell.x + 4.0 * cell.y) * 7.0);
    float far = clamp(reach * scale / max(-p.z, 1e-9), 2.0, 48.0);
    float hidden = 0.0;
    for (int i = 0; i < SAMPLES; i++) {
      float share = (float(i) + 0.5) / float(SAMPLES);
      float angle = turn + 2.399963 * float(i);
      vec3 v = at(place + far * share * one * vec2(cos(angle), sin(angle))) - p;
      float long2 = dot(v, v);
      float near = max(0.0, 1.0 - long2 / (reach * reach));
      hidden += near * max(0.0, dot(v, n) * inversesqrt(long2 + 1e-12 * reach * reach) - 0.12);
    }
    float sky = clamp(1.0 - 2.1 * hidden / float(SAMPLES), 0.0, 1.0);
    vec4 s = toSun * vec4(p + lift * n, 1.0);
    vec3 q = 0.5 * s.xyz / s.w + 0.5;
    float lit = 0.0;
    for (int i = 0; i < 6; i++) {
      float angle = turn + 1.0472 * float(i);
      vec2 off = sunPoint * (i < 3 ? 0.8 : 1.9) * vec2(cos(angle), sin(angle));
      lit += step(q.z - bias, texture2D(sun, q.xy + off).r);
    }
    float z = clamp((-p.z - clip.x) / (clip.y - clip.x), 0.0, 1.0) * 255.0;
    gl_FragColor = vec4(sky, lit / 6.0, floor(z) / 255.0, fract(z));
  }
`,SR=`
  uniform sampler2D light;
  uniform vec2 points;
  uniform float near;
  varying vec2 place;
  float depthOf(vec4 c) { return c.b + c.a / 255.0; }
  void main() {
    vec4 own = texture2D(light, place);
    float z = depthOf(own);
    vec3 sum = vec3(own.rg, 1.0);
    for (int y = -2; y < 2; y++) {
      for (int x = -2; x < 2; x++) {
        vec4 c = texture2D(light, place + vec2(float(x) + 0.5, float(y) + 0.5) / points);
        float w = step(abs(depthOf(c) - z), near);
        sum += w * vec3(c.rg, 1.0);
      }
    }
    gl_FragColor = vec4(sum.xy / sum.z, 0.0, 1.0);
  }
`,sg=new xr(new Uint8Array([255,255,255,255]),1,1);sg.needsUpdate=!0;function wx(n,e){n.onBeforeCompile=t=>{t.uniforms.shadeLight=e.light,t.uniforms.shadePoints=e.points,t.fragmentShader=t.fragmentShader.replace("void main() {",`uniform sampler2D shadeLight;
uniform vec2 shadePoints;
void main() {`).replace("#include <aomap_fragment>",`vec2 shade = texture2D(shadeLight, gl_FragCoord.xy / shadePoints).rg;
        reflectedLight.directDiffuse *= shade.g;
        reflectedLight.indirectDiffuse += 0.7 * abs(dot(normal, normalize(vViewPosition))) * BRDF_Lambert(diffuseColor.rgb);
        reflectedLight.indirectDiffuse *= shade.r;
        reflectedLight.directDiffuse *= 0.5 + 0.5 * shade.r;`)}}var Bf=class{constructor(e,t){this.renderer=e;this.software=t;let i=r=>{let a=new ai(r,r,{minFilter:en,magFilter:en});return a.depthTexture=new Ms(r,r,Ji),a};this.depth=i(4),this.sun=i(t?xR:bR),this.found=new ai(4,4,{minFilter:en,magFilter:en,depthBuffer:!1}),this.smooth=new ai(4,4,{depthBuffer:!1});let s=(r,a,o={})=>{let l=Object.fromEntries(a.map(c=>[c,{value:null}]));return new kf(new Fi({vertexShader:_R,fragmentShader:r,uniforms:l,defines:o,depthTest:!1,depthWrite:!1,blending:Mr}))};this.find=s(wR,["depth","sun","back","toSun","points","clip","reach","scale","lift","sunPoint","bias"],{SAMPLES:t?9:14}),this.mean=s(SR,["light","points","near"])}renderer;software;lit={light:{value:sg},points:{value:new Se(1,1)}};depth;found;smooth;sun;sunCamera=new Zi;own=new En;find;mean;stale=!0;moved(){this.stale=!0}clear(){this.lit.light.value=sg}draw(e,t,i,s,r){let{renderer:a,own:o,lit:l}=this,c=a.getDrawingBufferSize(l.points.value),h=this.software?yR:vR,[u,f]=[Math.ceil(c.x/h),Math.ceil(c.y/h)];for(let y of[this.depth,this.found,this.smooth])(y.width!==u||y.height!==f)&&y.setSize(u,f);this.stale&&this.fromSun(e,i,s),this.stale=!1,o.copy(t);let d=t.position.distanceTo(i.center);o.far=d+1.01*i.radius,o.near=Math.max(t.near,d-1.01*i.radius,1e-4*o.far),o.updateProjectionMatrix(),o.updateMatrixWorld();let p={color:a.getClearColor(new qe),alpha:a.getClearAlpha()};a.setRenderTarget(this.depth),a.render(e,o);let v=new St().multiplyMatrices(this.sunCamera.projectionMatrix,this.sunCamera.matrixWorldInverse).multiply(o.matrixWorld),m=2*i.radius/this.sun.width,g=new Se(u,f);_x(this.find,{depth:this.depth.depthTexture,sun:this.sun.depthTexture,back:o.projectionMatrixInverse,toSun:v,points:g,clip:new Se(o.near,o.far),reach:Math.min(Math.max(.9*r,.02*i.radius),.25*i.radius),scale:.5*f/Math.tan(Kn.degToRad(o.fov/2)),lift:1.6*m,sunPoint:1/this.sun.width,bias:.6*m/(2*i.radius)}),a.setRenderTarget(this.found),this.find.render(a),_x(this.mean,{light:this.found.texture,points:g,near:.02}),a.setRenderTarget(this.smooth),this.mean.render(a),a.setRenderTarget(null),a.setClearColor(p.color,p.alpha),l.light.value=this.smooth.texture}fromSun(e,t,i){let{sunCamera:s,renderer:r}=this,a=t.radius;Object.assign(s,{left:-a,right:a,top:a,bottom:-a,near:0,far:2*a}),s.position.copy(t.center).addScaledVector(i.clone().normalize(),a),s.up.set(0,0,1),s.lookAt(t.center),s.updateProjectionMatrix(),s.updateMatrixWorld(),r.setRenderTarget(this.sun),r.render(e,s)}};function _x(n,e){let{uniforms:t}=n.material;for(let[i,s]of Object.entries(e))t[i].value=s}var ER=.004,TR=12e4,AR=.03,RR=[1e6,1e5],CR=300,rg=[3,9],Sx=1e-5,PR=.02,Hf=class{constructor(e,t,i,s){this.shape=e;this.software=s;let{info:r}=e;this.dimension=r.dimension,this.size=r.size,this.ids=e.u32("ids"),this.count=this.ids.length,this.rest=e.f32("points"),this.offsets=e.u32("offsets"),this.facesOf=e.u32("facesOf"),this.faceEnds=e.u32("faceEnds"),this.corners=e.u32("corners"),this.twins=e.u32("twins");let a=e.u32("hollowEnds"),o=e.u32("hollowCorners");e.u32("hollow").forEach((f,d)=>{this.hollow.set(f,o.subarray(a[d],a[d+1]))});let l=this.faceEnds.length-1;this.blockOf=new Uint32Array(l);for(let f=0;f<this.count;f++)this.blockOf.fill(f,this.facesOf[f],this.facesOf[f+1]);this.twinOf=new Int32Array(l).fill(-1);for(let f=0;f<this.twins.length;f++)this.twinOf[this.twins[f]]=f>>1;for(let f=0;f<this.count;f++)this.isSurvey(f)&&this.surveys.push(f);this.middles=this.means(),this.positions=this.rest.slice(),this.shades=new Float32Array(this.count).fill(.25),this.drawnAs=new Uint32Array(this.positions.length/3),this.shown=new Uint8Array(this.count).fill(1),this.faceShown=new Uint8Array(l),this.geometry.boundingSphere=new vi,this.edgeGeometry.boundingSphere=this.geometry.boundingSphere;let c=this.dimension===2,h={map:t.texture,side:c?vn:$s,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},u=c?new oi(h):new Xs({...h,flatShading:!0});u instanceof Xs&&wx(u,i),this.mesh=new zt(this.geometry,u),this.cast=new zt(this.geometry,new oi({colorWrite:!1})),this.cast.frustumCulled=!1,this.lines=new Ss(this.edgeGeometry,new Ui({color:0,transparent:!0,opacity:c?.55:.35})),this.mesh.frustumCulled=!1,this.lines.frustumCulled=!1,this.section=new Ff(t.texture),this.side=new Uint8Array(this.count),this.ridges=new Of(this,f=>this.isSurvey(f)),this.object.add(this.mesh,this.lines,this.section.object),this.solid.add(this.cast,this.section.cast)}shape;software;object=new Zt;solid=new Zt;dimension;count;ids;positions;size;surveys=[];visibleFaces=0;rest;offsets;facesOf;faceEnds;corners;twins;hollow=new Map;places=new Map;blockOf;twinOf;middles;geometry=new vt;edgeGeometry=new vt;shades;drawn={count:0,points:new Uint32Array,blocks:new Uint32Array};drawnAs;mesh;cast;lines;section;side;cut=null;plane=new Ai;shown;faceShown;ridges;triangleFace=new Uint32Array;seen="";gaps=null;gapLimit=0;withEdges=!1;crowded=!1;clear=!1;ink="#000000";dispose(){this.geometry.dispose(),this.edgeGeometry.dispose(),this.mesh.material.dispose(),this.cast.material.dispose(),this.lines.material.dispose(),this.section.dispose()}set glass(e){let t=this.mesh.material;t.transparent=e,t.opacity=e?.14:1,t.depthWrite=!e,t.needsUpdate=!0,this.section.glass=e,this.clear=e,this.tint(this.ink)}tint(e){this.ink=e,this.lines.material.color.set(this.clear?e:"#000000")}fade(e,t=!1){let i=this.size/e,s=t?0:Math.min(1,(i-rg[0])/(rg[1]-rg[0]));this.lines.visible=this.withEdges&&s>0,this.lines.material.opacity=s*(this.dimension===2?.55:.35),this.section.fade(s)}get isSolid(){return this.dimension===3&&!this.clear}get sphere(){return this.geometry.boundingSphere}get cutBlocks(){return this.section.count}isCut(e){return this.cut!==null&&this.side[e]===2}get planes(){return this.cut?[this.plane]:[]}means(){let e=new Float32Array(3*this.count);for(let t=0;t<this.count;t++){let i=this.offsets[t],s=this.offsets[t+1],r=0,a=0,o=0;for(let c=3*i;c<3*s;c+=3)r+=this.rest[c],a+=this.rest[c+1],o+=this.rest[c+2];let l=Math.max(1,s-i);e.set([r/l,a/l,o/l],3*t)}return e}move(e,t){let i=e.f32("shifts"),s=t.exaggeration;this.dimension===2?mx(this,i,e.f32("turns"),s):gx(this,i,e.i16("turns"),e.info.turnScale/32767,s);let r=e.u32("bent"),a=e.f32("bentShifts"),o=0;for(let u of r)for(let f=3*this.offsets[u];f<3*this.offsets[u+1];f++)this.positions[f]=this.rest[f]+s*a[o++];this.gaps=e.has("gaps")?e.u8("gaps"):null;let{shutDecade:l,steps:c}=e.info,h=u=>Math.ceil((Math.log10(u/Math.max(s,1e-12))-l)*c)+1;this.gapLimit=h(ER),this.gaps&&this.openFaces(this.gapLimit)>TR&&(this.gapLimit=h(AR)),this.bound()}openFaces(e){let t=this.twins.length/2,i=0;for(let s=0;s<t;s++)(this.gaps[s>>1]>>4*(s&1)&15)>=e&&(i+=2);return i}bound(){let e=new tn,t=[1/0,1/0,1/0],i=[-1/0,-1/0,-1/0],{positions:s}=this;for(let r=0;r<s.length;r+=3)for(let a=0;a<3;a++){let o=s[r+a];o<t[a]&&(t[a]=o),o>i[a]&&(i[a]=o)}e.min.set(t[0],t[1],t[2]),e.max.set(i[0],i[1],i[2]),e.isEmpty()||e.getBoundingSphere(this.geometry.boundingSphere)}box(){return px(this)}paint(e,t){let{ids:i,shades:s}=this;for(let r=0;r<this.count;r++){let a=(!t.kinds||t.field==="material")&&this.isSurvey(r);s[r]=a?t.terrain:e?t.place(e[r],i[r]):t.tone(i[r])}}isSurvey(e){return this.dimension===3&&this.facesOf[e+1]-this.facesOf[e]>CR}reveal(e,t){let{shown:i,faceShown:s,twins:r,blockOf:a}=this;if(i.fill(1),e.clip&&this.takeAway(e.clip),this.cut=e.clip?.flat?e.clip:null,e.only&&t){let[o,l]=e.only;for(let c=0;c<this.count;c++)t[c]>=o&&t[c]<=l||(i[c]=0)}for(let o=0;o<s.length;o++)s[o]=i[a[o]];for(let o=0;o<r.length;o+=2){let l=r[o],c=r[o+1];if(!s[l]||!s[c]||this.cut&&(this.side[a[l]]===2||this.side[a[c]]===2))continue;let h=o>>1;(this.gaps?this.gaps[h>>1]>>4*(h&1)&15:15)<this.gapLimit&&(s[l]=0,s[c]=0)}this.index(e.edges),this.send(),this.close(e.edges)}clearOf(e,t){if(this.dimension===2)return t;let{positions:i,corners:s,faceEnds:r}=this,a=PR*this.size,[o,l,c]=e,h=new Float32Array(i.length/3);for(let f=0;f<h.length;f++)h[f]=o*i[3*f]+l*i[3*f+1]+c*i[3*f+2]-t;let u=f=>{for(let d=0;d+1<r.length;d++){let p=r[d];for(;p<r[d+1]&&Math.abs(h[s[p]]-f)<a;)p++;if(p===r[d+1])return!1}return!0};for(let f of[0,1,-1,2,-2,4,-4])if(u(2*f*a))return t+2*f*a;return t}takeAway(e){let{shown:t,side:i,middles:s}=this;if(e.flat){bx(this,e,Sx*this.size,i);for(let l=0;l<this.count;l++)i[l]===0&&(t[l]=0);return}let[r,a,o]=e.normal;for(let l=0;l<this.count;l++){let c=r*s[3*l]+a*s[3*l+1]+o*s[3*l+2]-e.at;e.keep*c<0&&(t[l]=0)}}close(e){let{cut:t,side:i,shown:s}=this;for(let a of[this.mesh,this.lines,this.cast])a.material.clippingPlanes=this.planes;if(!t){this.section.clear();return}this.plane.normal.set(...t.normal).multiplyScalar(t.keep),this.plane.constant=Sx*this.size-t.keep*t.at;let r=[];for(let a=0;a<this.count;a++)i[a]===2&&s[a]&&r.push(a);this.section.draw(xx(this,t,r),this.shades,e)}send(){let{count:e,points:t,blocks:i}=this.drawn,s=this.geometry.getAttribute("position"),r=this.geometry.getAttribute("uv"),a=s.array,o=r.array,{positions:l,shades:c}=this;for(let h=0;h<e;h++){let u=3*t[h];a[3*h]=l[u],a[3*h+1]=l[u+1],a[3*h+2]=l[u+2],o[2*h]=c[i[h]]}zf(s,3*e),zf(r,2*e)}room(e,t,i){let s=this.geometry.getAttribute("position");if(!s||s.count<e){let r=Math.ceil(1.25*e)+64;this.geometry.dispose(),this.edgeGeometry.dispose();let a=new ln(new Float32Array(3*r),3).setUsage(Ec),o=new ln(new Float32Array(2*r),2).setUsage(Ec);this.geometry.setAttribute("position",a),this.geometry.setAttribute("uv",o),this.edgeGeometry.setAttribute("position",a),this.drawn.points=new Uint32Array(r),this.drawn.blocks=new Uint32Array(r)}for(let[r,a]of[[this.geometry,t],[this.edgeGeometry,i]]){let o=r.getIndex();if(o&&o.count>=a)continue;r.dispose();let l=new ln(new Uint32Array(Math.ceil(1.25*a)+64),1);r.setIndex(l.setUsage(Ec))}}index(e){let{faceShown:t,faceEnds:i,corners:s}=this,r=0,a=0,o=0,l=0;for(let b=0;b<t.length;b++)t[b]&&(l=Math.imul(l,31)+b|0,r++,o+=i[b+1]-i[b],a+=this.hollow.has(b)?this.hollow.get(b).length/3:i[b+1]-i[b]-2);this.visibleFaces=r,this.crowded=r>RR[this.software?1:0]&&this.dimension===3;let c=e&&!this.crowded,h=`${l} ${r} ${c}`;if(this.withEdges=c,h===this.seen)return;this.seen=h,this.room(o,3*a,c?2*o:0);let u=this.geometry.getIndex().array,f=this.edgeGeometry.getIndex().array,d=new Uint32Array(a),{drawn:p,drawnAs:v}=this,m=4294967295;v.fill(m),p.count=0;let g=0,y=0,_=this.dimension===2,x=-1,T=0,M=new Int32Array;for(let b=0;b<t.length;b++){if(!t[b])continue;let S=i[b],C=i[b+1];for(let L=S;L<C;L++){let O=s[L];v[O]===m&&(v[O]=p.count,p.points[p.count]=O,p.blocks[p.count++]=this.blockOf[b])}let I=this.hollow.get(b);if(I){d.fill(b,g/3,(g+I.length)/3);for(let L of I)u[g++]=v[L]}else for(let L=S+1;L+1<C;L++)d[g/3]=b,u[g++]=v[s[S]],u[g++]=v[s[L]],u[g++]=v[s[L+1]];if(c){let L=this.blockOf[b];!_&&L!==x&&(x=L,T=i[this.facesOf[L]],M=this.ridges.at(L));for(let O=S;O<C;O++){if(!_){let z=M[O-T],U=z>>1;if(z!==-1&&t[U]&&(U<b||!(z&1)))continue}f[y++]=v[s[O]],f[y++]=v[s[O+1<C?O+1:S]]}}}this.triangleFace=d,zf(this.geometry.getIndex(),g),zf(this.edgeGeometry.getIndex(),y),this.geometry.setDrawRange(0,g),this.edgeGeometry.setDrawRange(0,y)}pick(e){return this.hit(e)?.block??null}hit(e){let t=this.section.pick(e),i=e.intersectObject(this.mesh,!1).find(r=>!this.isAway(r.point));if(t&&(!i||t.distance<i.distance))return{block:t.block,point:e.ray.at(t.distance,new P)};if(!i||i.faceIndex===void 0||i.faceIndex===null)return null;let s=this.blockOf[this.triangleFace[i.faceIndex]];return s===void 0?null:{block:s,point:i.point}}cornersOf(e){let t=[];for(let i=this.offsets[e];i<this.offsets[e+1];i++)t.push(new P().fromArray(this.positions,3*i));return t}diagonal(e){if(e>=this.count)return NaN;let[t,i]=[new P(1/0,1/0,1/0),new P(-1/0,-1/0,-1/0)],s=new P;for(let r=this.offsets[e];r<this.offsets[e+1];r++)s.fromArray(this.rest,3*r),t.min(s),i.max(s);return i.distanceTo(t)}placeOf(e){return this.places.size===0&&this.ids.forEach((t,i)=>this.places.set(t,i)),this.places.get(e)??-1}isShown(e){return this.shown[e]===1}isAway(e){return this.cut!==null&&this.plane.distanceToPoint(e)<0}outline(e){let t=[];for(let i=this.facesOf[e];i<this.facesOf[e+1];i++){let s=this.faceEnds[i],r=this.faceEnds[i+1];for(let a=s;a<r;a++)for(let o of[this.corners[a],this.corners[a+1<r?a+1:s]])t.push(...this.positions.subarray(3*o,3*o+3))}return Float32Array.from(t)}};function zf(n,e){n.clearUpdateRanges(),n.addUpdateRange(0,e),n.needsUpdate=!0}function Mx(n){return n.reduce((e,[t,i],s)=>{let[r,a]=n[(s+1)%n.length];return e+t*a-r*i},0)}function IR(n,e){let t=n;return e.forEach(([i,s],r)=>{let[a,o]=e[(r+1)%e.length],l=([h,u])=>(a-i)*(u-s)-(o-s)*(h-i),c=[];t.forEach((h,u)=>{let f=t[(u+1)%t.length],[d,p]=[l(h),l(f)];if(d>=0&&c.push(h),d>=0!=p>=0){let v=d/(d-p);c.push([h[0]+v*(f[0]-h[0]),h[1]+v*(f[1]-h[1])])}}),t=c}),t}function Ex(n,e,t,i){let{rest:s,corners:r,faceEnds:a}=n,o=C=>Array.from(r.subarray(a[C],a[C+1])),[l,c]=[o(e),o(t)],h=new P().fromArray(s,3*l[1]).sub(new P().fromArray(s,3*l[0])).normalize(),u=i.clone().cross(h),f=C=>{let I=new P().fromArray(s,3*C).sub(new P().fromArray(s,3*l[0]));return[h.dot(I),u.dot(I)]},[d,p]=[l.map(f),c.map(f)],v=IR(d,Mx(p)<0?p.reverse():p),m=.5*Mx(v);if(v.length<3||!(m>0))return null;let g=C=>Math.abs(d[1][0]*d[C][1]-d[1][1]*d[C][0]),y=2;for(let C=3;C<d.length;C++)g(C)>g(y)&&(y=C);let[[_,x],[T,M]]=[d[1],d[y]],b=_*M-x*T,S=v.flatMap(([C,I])=>[(C*M-I*T)/b,(_*I-x*C)/b]);return{size:m,piece:{base:[l[0],l[1],l[y]],shares:S}}}var LR=15,Tx=8,Ax="#9a9a9a",Rx=.002,Vf=class{object;known=new WeakMap;constructor(){this.object=new zt(new vt,new Xs({vertexColors:!0,side:vn,flatShading:!0})),this.object.frustumCulled=!1,this.object.visible=!1,this.object.renderOrder=2}draw(e,t,i,s){if(this.object.visible=!1,e==="")return[];let r=this.known.get(t);if(!r){let h=t.dimension===3?DR(t):UR(t);r={joints:h,sets:kR(h,t.dimension)},this.known.set(t,r)}let a=e==="set"?r.sets:BR(r.joints,t.dimension,i,s),o=[],l=[];for(let{note:h,joints:u}of a){let f=u.filter(g=>t.isShown(g.blocks[0])&&t.isShown(g.blocks[1])),d=o.length,p=f.filter(g=>!g.piece).map(g=>g.blocks);for(let g of If(t,p).points)o.push(g);let v=t.dimension===3?OR:FR;for(let{piece:g}of f)g&&v(t,g,o);let m=new qe(h.colour).toArray();for(let g=d;g<o.length;g+=3)l.push(...m)}let{geometry:c}=this.object;return c.dispose(),c.setAttribute("position",new tt(o,3)),c.setAttribute("color",new tt(l,3)),c.deleteAttribute("normal"),t.dimension===2&&c.setAttribute("normal",new tt(o.map((h,u)=>u%3===2?1:0),3)),this.object.material.clippingPlanes=t.planes,this.object.visible=o.length>0,a.map(h=>h.note)}};function Cx(n,e){let{rest:t,corners:i,faceEnds:s}=n,[r,a,o,l]=[new P,new P,new P,new P];a.fromArray(t,3*i[s[e]]);for(let c=s[e]+1;c+1<s[e+1];c++)o.fromArray(t,3*i[c]).sub(a),l.fromArray(t,3*i[c+1]).sub(a),r.add(o.cross(l));return r}function DR(n){let{twins:e,blockOf:t}=n,i=[],s=new Set(e);for(let r=0;r<e.length;r+=2){let[a,o]=[e[r],e[r+1]],l=Cx(n,a),c=.5*l.length();c>0&&i.push({blocks:[t[a],t[o]],axis:l.normalize(),size:c})}return[...i,...NR(n,s)]}function NR(n,e){let{rest:t,corners:i,faceEnds:s,blockOf:r,size:a}=n,o=Rx*a,l=new Map,c=(v,m,g)=>[...v.toArray().map((y,_)=>Math.round(y/.02)+g[_]),Math.round(m/(4*o))+g[3]].join(" "),h=[];for(let v=0;v+1<s.length;v++){if(e.has(v))continue;let m=Cx(n,v);if(!(m.length()>o*o))continue;m.normalize();let g=Array.from(i.subarray(s[v],s[v+1]),b=>Array.from(t.subarray(3*b,3*b+3))),[y,_]=[Math.min,Math.max].map(b=>[0,1,2].map(S=>b(...g.map(C=>C[S])))),x={face:v,normal:m,off:m.dot(new P(...g[0])),low:y,high:_};h.push(x);let T=c(m,x.off,[0,0,0,0]),M=l.get(T);M?M.push(x):l.set(T,[x])}let u=[-1,0,1],f=u.flatMap(v=>u.flatMap(m=>u.flatMap(g=>u.map(y=>[v,m,g,y])))),d=[],p=new P;for(let v of h){p.copy(v.normal).negate();for(let m of f)for(let g of l.get(c(p,-v.off,m))??[]){let[y,_]=[v.face,g.face];if(_<y||r[y]===r[_]||Math.abs(v.off+g.off)>2*o||[0,1,2].some(T=>v.low[T]>g.high[T]+o||g.low[T]>v.high[T]+o))continue;let x=Ex(n,y,_,v.normal);x&&x.size>o*a&&d.push({blocks:[r[y],r[_]],axis:v.normal.clone(),...x})}}return d}function UR(n){let{rest:e,corners:t,faceEnds:i,blockOf:s,size:r}=n,a=Rx*r,o=new Map,l=(h,u,f)=>`${Math.round(Math.atan2(h.direction[1],h.direction[0])/.01)+u} ${Math.round(h.off/(4*a))+f}`,c=[];for(let h=0;h+1<i.length;h++)for(let u=i[h];u<i[h+1];u++){let[f,d]=[t[u],t[u+1<i[h+1]?u+1:i[h]]],[p,v]=[e[3*d]-e[3*f],e[3*d+1]-e[3*f+1]],m=Math.hypot(p,v);if(!(m>a))continue;let g=p>1e-6*m||Math.abs(p)<=1e-6*m&&v>0?1:-1;[p,v]=[g*p/m,g*v/m];let y=S=>p*e[3*S]+v*e[3*S+1],_={block:s[h],corners:[f,d],ends:[y(f),y(d)],direction:[p,v],off:p*e[3*f+1]-v*e[3*f]},[x,T]=[Math.min(..._.ends),Math.max(..._.ends)];for(let S=-1;S<=1;S++)for(let C=-1;C<=1;C++)for(let I of o.get(l(_,S,C))??[]){let L=Math.max(x,Math.min(...I.ends)),O=Math.min(T,Math.max(...I.ends));if(I.block===_.block||O-L<=a||Math.abs(I.off-_.off)>2*a)continue;let z=U=>(U-_.ends[0])/(_.ends[1]-_.ends[0]);c.push({blocks:[_.block,I.block],axis:new P(p,v,0),size:O-L,piece:{base:[f,d],shares:[z(L),z(O)]}})}let M=l(_,0,0),b=o.get(M);b?b.push(_):o.set(M,[_])}return c}function og(n){let{low:e,high:t}=n.shape.info;return Math.min(.025*n.size,Math.hypot(t[0]-e[0],t[1]-e[1])/500)}function FR(n,{base:e,shares:t},i){let{positions:s}=n,r=(v,m)=>(1-t[v])*s[3*e[0]+m]+t[v]*s[3*e[1]+m],[a,o,l,c]=[r(0,0),r(0,1),r(1,0),r(1,1)],h=Math.hypot(l-a,c-o)||1,u=og(n),[f,d]=[-(c-o)/h*u,(l-a)/h*u],p=.35;i.push(a-f,o-d,p,l-f,c-d,p,l+f,c+d,p,a-f,o-d,p,l+f,c+d,p,a+f,o+d,p)}function OR(n,{base:e,shares:t},i){let{positions:s}=n,[r,a,o]=e,l=c=>{for(let h=0;h<3;h++){let u=s[3*r+h];i.push(u+t[2*c]*(s[3*a+h]-u)+t[2*c+1]*(s[3*o+h]-u))}};for(let c=1;2*c+2<t.length;c++)[0,c,c+1].forEach(l)}function kR(n,e){let t=Math.cos(Kn.degToRad(LR)),i=[];for(let a of[...n].sort((o,l)=>l.size-o.size)){let o,l=t;for(let c of i){let h=Math.abs(c.sum.dot(a.axis))/c.sum.length();h>l&&([o,l]=[c,h])}o||(o={sum:new P,size:0,joints:[]},i.push(o)),o.sum.addScaledVector(a.axis,o.sum.dot(a.axis)<0?-a.size:a.size),o.size+=a.size,o.joints.push(a)}i.sort((a,o)=>o.size-a.size);let s=i.slice(0,Tx).map((a,o)=>({note:{text:`set ${o+1}: ${zR(a.sum,e)}, ${ag(a.size,e)}`,colour:Cr(o)},joints:a.joints})),r=i.slice(Tx);if(r.length>0){let a=r.reduce((o,l)=>o+l.size,0);s.push({note:{text:`other directions, ${ag(a,e)}`,colour:Ax},joints:r.flatMap(o=>o.joints)})}return s}function BR(n,e,t,i){if(!t||!i)return[];let s=Math.round(Math.sqrt(t.pairs.length)),r=new Map;for(let a of n){let[o,l]=a.blocks.map(u=>i[u]),c=t.pairs[o*s+l]??-1,h=r.get(c)??{size:0,joints:[]};h.size+=a.size,h.joints.push(a),r.set(c,h)}return[...r].sort(([a],[o])=>a-o).map(([a,{size:o,joints:l}])=>({note:{text:`${t.interfaces[a]??"no law"}: ${ag(o,e)}`,colour:a<0?Ax:Cr(a)},joints:l}))}function zR(n,e){let t=a=>Math.round(Kn.radToDeg(a));if(e===2)return`${(t(Math.atan2(n.y,n.x))+180)%180}\xB0 from x`;let i=n.clone().normalize();i.z<0&&i.negate();let s=t(Math.acos(Math.min(1,i.z))),r=(t(Math.atan2(i.x,i.y))+360)%360;return`${String(s).padStart(2,"0")}\xB0/${s===0?"\u2013":`${String(r).padStart(3,"0")}\xB0`}`}function ag(n,e){return`${qt(n,3)} ${e===3?"m\xB2":"m"}`}var lg={held:{name:"held",colour:"#2f7bd9"},roller:{name:"rollers",colour:"#2aa7a0"},held_along:{name:"held along the face",colour:"#6b7fd7"},moved:{name:"moved",colour:"#e07b1a"},viscous:{name:"viscous",colour:"#8a5cc4"},loaded:{name:"loaded",colour:"#d0342c"}},Px="#c2187a",Ix="#1f8fe0",HR=400,Gf=class{object=new Zt;faces;arrows;surface;known=new WeakMap;reach=new tn;constructor(){this.faces=new zt(new vt,new oi({vertexColors:!0,side:vn,transparent:!0,opacity:.8,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-2}));let e={depthTest:!1,transparent:!0};this.arrows={plane:new sa(!0,e),space:new sa(!1,e)};for(let t of Object.values(this.arrows))t.colour=Px;this.surface=new zt(new vt,new oi({color:Ix,side:vn,transparent:!0,opacity:.35,depthWrite:!1}));for(let t of[this.faces,this.surface])t.frustumCulled=!1,t.visible=!1,t.renderOrder=2;this.object.add(this.faces,this.surface,this.arrows.plane.object,this.arrows.space.object)}places(e,t){let i=this.known.get(t);if(i)return i;i=[];let{origin:s}=t.shape.info,r=new P;return e.faces.forEach(({blocks:a,centres:o},l)=>{a.forEach((c,h)=>{let u=t.placeOf(c);if(u<0)return;let f=o[h];r.set(f[0]-s[0],f[1]-s[1],f[2]-s[2]);let d=-1,p=1/0;for(let v=t.facesOf[u];v<t.facesOf[u+1];v++){let m=qR(t,v,r);m<p&&([d,p]=[v,m])}d>=0&&i.push({condition:l,item:h,block:u,face:d})})}),this.known.set(t,i),i}drawFaces(e,t){if(this.faces.visible=!1,!e||t.dimension===2)return[];let i=[],s=[],r=e.faces.map(u=>new qe(lg[u.kind].colour).toArray()),{positions:a,corners:o,faceEnds:l}=t;for(let{condition:u,block:f,face:d}of this.places(e,t)){if(!t.isShown(f))continue;let p=l[d];for(let v=p+1;v+1<l[d+1];v++)for(let m of[o[p],o[v],o[v+1]])i.push(a[3*m],a[3*m+1],a[3*m+2]),s.push(...r[u])}let{geometry:c}=this.faces;c.dispose(),c.setAttribute("position",new tt(i,3)),c.setAttribute("color",new tt(s,3)),this.faces.visible=i.length>0,this.faces.material.clippingPlanes=t.planes;let h=[];for(let u of Object.keys(lg)){let f=e.faces.filter(g=>g.kind===u),d=f.reduce((g,y)=>g+y.count,0);if(d===0)continue;let p=f.some(g=>g.blocks.length===0)?", too many to draw":"",{name:v,colour:m}=lg[u];h.push({text:`${v}: ${d} face${d===1?"":"s"}${p}`,colour:m})}return h}drawLoads(e,t,i,s){let r=t.dimension===2,a=r?this.arrows.plane:this.arrows.space;for(let d of Object.values(this.arrows))d.clear();if(this.reach.makeEmpty(),!e)return[];let o=[...GR(e,t),...this.tractions(e,t)],l=new Map;for(let{kind:d,unit:p,vector:v}of o){let m=l.get(d),g=v.length();m&&m.count++,(!m||g>m.size)&&l.set(d,{size:g,unit:p,count:m?m.count:1})}let c=[],h=[],u=new P,f=new P;for(let{kind:d,block:p,place:v,vector:m}of o){let{size:g}=l.get(d);!(g>0)||r&&d==="moment"||!t.isShown(p)||(f.copy(m).divideScalar(g),u.copy(v).add(i(p,new P)),u.addScaledVector(f,-s),c.push(...u.toArray()),this.reach.expandByPoint(u),h.push(...f.toArray()))}return c.length>0&&a.draw(new Float32Array(c),new Float32Array(h),1,s),[...l].map(([d,{size:p,unit:v,count:m}])=>({text:`${m===1?d:`${m} ${VR[d]??d}, up to`} ${pn(p,v,3)}`,colour:Px}))}tractions(e,t){if(t.dimension===2)return[];let i=this.places(e,t).filter(a=>e.faces[a.condition].tractions.length>0),s=Math.max(1,Math.ceil(i.length/HR)),{origin:r}=t.shape.info;return i.filter((a,o)=>o%s===0).map(({condition:a,item:o,block:l})=>{let{centres:c,tractions:h}=e.faces[a],u=new P(...c[o]).sub(new P(...r));return{kind:"traction",unit:"Pa",block:l,place:u,vector:new P(...h[o])}})}drawWater(e,t,i){this.surface.visible=!1;let s=e?.standing.find(([l])=>l===i)??e?.standing[0],r=s&&s[1]!==null?e.water[s[1]]:void 0;if(!r)return[];let a=t.dimension===2,o=[];for(let l of r.parts??[r])o.push(...l.grid?WR(l.grid,t):XR(l,t));return this.surface.geometry.dispose(),this.surface.geometry.setAttribute("position",new tt(o,3)),this.surface.material.opacity=a?.9:.35,this.surface.visible=!0,[{text:`water table ${r.name}`,colour:Ix}]}},VR={force:"forces",moment:"moments",pressure:"arrows of pressure",acceleration:"accelerations",traction:"faces loaded"};function GR(n,e){let{origin:t}=e.shape.info;return n.loads.flatMap(({kind:i,unit:s,block:r,at:a,vector:o})=>{let l=e.placeOf(r),c=new P(...a).sub(new P(...t));return e.dimension===2&&(c.z=0),l<0?[]:[{kind:i,unit:s,block:l,place:c,vector:new P(...o)}]})}function WR([n,e,t],i){let{origin:s}=i.shape.info,r=(o,l)=>[n[o]-s[0],e[l]-s[1],t[l*n.length+o]-s[2]],a=[];for(let o=0;o+1<e.length;o++)for(let l=0;l+1<n.length;l++){let[c,h,u,f]=[r(l,o),r(l+1,o),r(l+1,o+1),r(l,o+1)];a.push(...c,...h,...u,...c,...u,...f)}return a}function XR(n,e){let{low:t,high:i,origin:s}=e.shape.info,r=e.dimension===2,a=(y,_)=>n.along[0]*(y+s[0])+n.along[1]*(_+s[1]),o=r?[t[0]+s[0],i[0]+s[0]]:[0,1,2,3].map(y=>a(y&1?i[0]:t[0],y&2?i[1]:t[1])),[l,c]=[Math.min(...o),Math.max(...o)];r&&n.within&&([l,c]=[Math.max(l,n.within[0][0]),Math.min(c,n.within[1][0])]);let h=$R(n.points,l,c),u=[];if(r){let y=og(e);for(let _=0;_+1<h.length;_++){let[[x,T],[M,b]]=[h[_],h[_+1]].map(([S,C])=>[S-s[0],C-s[1]]);u.push(x,T-y,.45,M,b-y,.45,M,b+y,.45,x,T-y,.45,M,b+y,.45,x,T+y,.45)}return u}let[f,d]=n.along,p=.5*Math.hypot(i[0]-t[0],i[1]-t[1]),v=[s[0]+.5*(t[0]+i[0]),s[1]+.5*(t[1]+i[1])],m=-d*v[0]+f*v[1],g=([y,_],x)=>{let T=m+x*p;return[f*y-d*T-s[0],d*y+f*T-s[1],_-s[2]]};for(let y=0;y+1<h.length;y++){let[_,x]=[h[y],h[y+1]];u.push(...g(_,-1),...g(x,-1),...g(x,1),...g(_,-1),...g(x,1),...g(_,1))}return u}function $R(n,e,t){let i=s=>{let r=n.findIndex(h=>h[0]>s);if(r===0)return n[0][1];if(r<0)return n.at(-1)[1];let[[a,o],[l,c]]=[n[r-1],n[r]];return o+(c-o)*(s-a)/(l-a)};return[[e,i(e)],...n.filter(s=>s[0]>e&&s[0]<t),[t,i(t)]]}function qR(n,e,t){let{rest:i,corners:s,faceEnds:r}=n,[a,o]=[r[e],r[e+1]],l=new P().fromArray(i,3*s[a]),c=new P,[h,u]=[new P,new P];for(let f=a+1;f+1<o;f++)h.fromArray(i,3*s[f]).sub(l),u.fromArray(i,3*s[f+1]).sub(l),c.add(h.cross(u));return Math.abs(c.normalize().dot(h.subVectors(t,l)))}var Lx=250,Wf=class{object=J("div.loading",{role:"status","aria-live":"polite",hidden:!0});all=new Set;timer=0;begin(e,t="bytes",i=null){let s={what:e,got:0,of:i,unit:t,since:performance.now()};return this.all.add(s),this.timer||(this.timer=window.setInterval(()=>this.say(),Lx/2)),s}end(e){this.all.delete(e),!(this.all.size>0)&&(clearInterval(this.timer),this.timer=0,this.object.hidden=!0)}async announce(e){let t=this.begin(e);return this.object.hidden=!1,this.write(t),await new Promise(i=>setTimeout(i,30)),t}say(){let e=performance.now(),[t]=[...this.all].filter(i=>e-i.since>Lx).sort((i,s)=>(s.of??0)-(i.of??0)||i.since-s.since);t&&(this.object.hidden=!1,this.write(t))}write({what:e,got:t,of:i,unit:s,since:r}){let a=Math.floor((performance.now()-r)/1e3),o=h=>s==="bytes"?(h/1e6).toFixed(h<1e7?1:0):String(h),l=i===null?a>1?`, ${a} s`:"":`: ${o(t)} of ${o(i)} ${s==="bytes"?"MB":"frames"}`,c=i===null?null:J("progress",{max:i,value:t});this.object.replaceChildren(J("span",{},`${e}${l}`),...c?[c]:[])}},YR={summary:"the run",shape:"the shapes of the blocks",frame:"the places of the blocks",contacts:"the contacts",cracks:"the cracks",bolts:"the bolts",stress:"the stresses",conditions:"the conditions",names:"the names",table:"the histories"};function Dx(n){let[e,t=""]=n.split(/[/?](.*)/s),i=new URLSearchParams(n.split("?")[1]??"").get("name");return i?`Reading ${i}`:e==="block"?`Reading block ${t.split("/")[1]??""}`:`Reading ${YR[e]??n}`}var jR={f32:Float32Array,f64:Float64Array,u32:Uint32Array,i16:Int16Array,u8:Uint8Array},Nc=class{info;bytes;arrays=new Map;constructor(e){let t=new DataView(e).getUint32(0,!0),i=JSON.parse(new TextDecoder().decode(new Uint8Array(e,4,t)));this.info=i.info,this.bytes=e.byteLength;let s=Math.ceil((4+t)/8)*8;for(let r of i.arrays)this.arrays.set(r.name,new jR[r.type](e,s+r.at,r.length))}has(e){return this.arrays.has(e)}f32(e){return this.get(e)}f64(e){return this.get(e)}u32(e){return this.get(e)}i16(e){return this.get(e)}u8(e){return this.get(e)}get(e){let t=this.arrays.get(e);if(!t)throw new Error(`the answer has no array ${e}`);return t}};var Dn=class extends Error{constructor(t,i){super(t);this.what=t;this.hint=i}what;hint},Xf=class{constructor(e,t){this.run=e;this.loading=t}run;loading;json(e){return this.told(e,async t=>await t.json())}packet(e){return this.told(e,async(t,i)=>new Nc(await ZR(t,i)))}async told(e,t){let i=this.loading.begin(Dx(e));try{return await t(await this.ask(e),i)}finally{this.loading.end(i)}}file(e){return`api/${this.run}/file/${e}`}async ask(e){let t;try{t=await fetch(`api/${this.run}/${e}`)}catch{throw new Dn("The viewer does not answer any more.","Start it again: riprap view RUN")}if(t.ok)return t;let i=await t.json().catch(()=>({}));throw new Dn(i.what??`${e}: ${t.status}`,i.hint??"Reload the page.")}};async function ZR(n,e){let t=Number(n.headers.get("content-length"));if(!n.body||!(t>1e6))return n.arrayBuffer();e.of=t;let i=new Uint8Array(t),s=n.body.getReader();for(;;){let{done:r,value:a}=await s.read();if(r)break;i.set(a,e.got),e.got+=a.length}if(e.got!==t)throw new Dn("The answer of the viewer was cut off.","Reload the page.");return i.buffer}var $f=class{constructor(e){this.answers=e}answers;async json(e){return JSON.parse(new TextDecoder().decode(await this.bytes(e)))}async packet(e){return new Nc(await this.bytes(e))}file(){}async bytes(e){let t=this.answers.get(e);if(typeof t=="object"&&(t=this.answers.get(t.as)),typeof t!="string")throw new Dn("The report does not hold this.","Look at the run itself: riprap view RUN");let i=Uint8Array.from(atob(t),r=>r.charCodeAt(0)),s=new Blob([i]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(s).arrayBuffer()}};function cg(n,e){let t=n.blocks.findLast(i=>i.first<=e);return!t||e>=t.first+(t.count??1)?"":t.from===void 0?t.name:`${t.name}.${t.from+e-t.first}`}async function Nx(n,e,t){let i=await n.motion(e);return(await n.shape(i.info.shape,e)).u32("ids").indexOf(t)}async function Ux(n,e,t){let i=await Nx(n,e,t);if(i<0)throw new Dn(`there is no block ${t} in this frame`,"It was split, cut or removed.");let{held:s,names:r,fields:a}=n.summary,o=await Promise.all((r??[]).map(async h=>{let u=a.find(d=>d.name===h)?.components??1;if(s.vectors.includes(h)){let d=await n.vectors(e,h);return{name:h,unit:d.info.unit,values:[...d.f32("values").subarray(3*i,3*i+u)]}}let f=await n.field(e,h).catch(()=>null);return{name:h,unit:f?.info.unit??"",values:f?[f.f32("values")[i]]:[]}})),{names:l}=n,c=l.groups.filter(h=>h.blocks.some(([u,f])=>u<=t&&t<=f)).map(h=>h.name);return{block:t,name:cg(l,t),groups:c,frame:e,columns:o.filter(h=>h.values.length>0)}}async function Fx(n,e,t,i){let s=[],r="";for(let a=0;a<n.frames;a++){let o=await Nx(n,a,e),l=o<0?null:await n.field(a,t).catch(()=>null);r=l?.info.unit??r;let c=l?.f32("values")[o];s.push(c!==void 0&&Number.isFinite(c)?c:null)}i(s,r)}var JR=4e8;function hg(n){let e=pn(n.time,"s");if(!n.still)return e;let t=[n.phase,`step ${n.step}`].filter(Boolean);return(n.time===0?t:[e,...t]).join(", ")}var qf=class n{constructor(e,t){this.source=e;this.summary=t}source;summary;memory=new Map;held=0;ranges=new Map;conditions=null;names={blocks:[],groups:[]};static async open(e){return new n(e,await e.json("summary"))}get frames(){return this.summary.times?.length??0}async refresh(){let e=await this.source.json("summary");if(e.problem&&!this.summary.problem)throw new Dn(e.problem.what,e.problem.hint);let t=this.summary.manifest,i=!e.problem&&(e.manifest.started!==t?.started||e.manifest.input_hash!==t.input_hash);return i&&(this.memory.clear(),this.held=0),e.times?.length!==this.summary.times?.length&&this.ranges.clear(),this.summary=e,i}async readModel(){[this.conditions,this.names]=await Promise.all([this.source.json("conditions").catch(()=>null),this.source.json("names").catch(()=>this.names)])}get hasStress(){let{held:e,fields:t}=this.summary;return e?e.stress:(t??[]).some(i=>i.name==="stress_shear")}called(e){return cg(this.names,e)||`block ${e}`}motion(e){return this.packet(`frame/${e}`)}shape(e,t){return this.packet(`shape/${t}`,`shape ${e}`)}field(e,t){return this.packet(`field/${e}?name=${encodeURIComponent(t)}`)}vectors(e,t){return this.packet(`vectors/${e}?name=${encodeURIComponent(t)}`)}contacts(e){return this.packet(`contacts/${e}`)}cracks(e){return this.packet(`cracks/${e}`)}bolts(e){return this.packet(`bolts/${e}`)}stress(e){return this.packet(`stress/${e}`)}block(e,t){return this.summary.held?Ux(this,e,t):this.source.json(`block/${e}/${t}`)}async history(e,t,i){let s=[];if(this.summary.held)return Fx(this,e,t,i);let r=24;for(let a=0;a<this.frames;a+=r){let o=await this.source.json(`history/${e}?name=${encodeURIComponent(t)}&from=${a}&count=${r}`);if(s.push(...o.values.map(l=>typeof l=="number"?l:null)),!i(s,o.unit))return}}hasField(e){let t=e.replace(/\.(x|y|z|magnitude)$/,"");return(this.summary.fields??[]).some(i=>i.name===t)}range(e){let t=this.ranges.get(e);if(t!==void 0)return t;let i=this.readRange(e);return this.ranges.set(e,i),i.catch(()=>this.ranges.delete(e)),i}async readRange(e){let t={range:null,most:null},i=24,s=this.summary.held!==void 0;for(let r=0;r<(s?1:this.frames);r+=i){let a=s?"":`&from=${r}&count=${i}`,o=await this.source.json(`range?name=${s?e:encodeURIComponent(e)}${a}`);t.range=Yf(t.range,o.range),t.most=Yf(t.most,o.most??o.range)}return t}async table(e){let t=await this.source.packet(`table/${e}`),i=t.info.columns,s=i.map((l,c)=>c).filter(l=>!["time","step"].includes(i[l].name)),r=l=>{let c=i.findIndex(h=>h.name===l);return c<0?new Float64Array:t.f64(String(c))},a=r("time"),o=a.length>1&&a.every(l=>l===a[0]);return{names:s.map(l=>i[l].name),units:s.map(l=>i[l].unit),columns:s.map(l=>t.f64(String(l))),x:o?r("step"):a,bySteps:o}}moments(){let e=0,{steps:t,phases:i}=this.summary;return(this.summary.times??[]).map((s,r,a)=>{e=r>0&&a[r-1]===s?e+1:0;let o=e>0||a[r+1]===s;return{time:s,nth:e,step:t[r]??0,phase:i[r]??"",still:o}})}saidAt(e){let t=this.moments()[e];return t?hg(t):""}frameAt(e){let t=this.moments(),i=1e-9*Math.abs(e.time),s=0,r=t.length;for(;s<r;){let a=s+r>>1,{time:o,nth:l}=t[a];(Math.abs(o-e.time)<=i?l<=e.nth:o<e.time)?s=a+1:r=a}return Math.max(0,s-1)}packet(e,t=e){let i=this.memory.get(t);if(i)return this.memory.delete(t),this.memory.set(t,i),i.answer;let s=this.source.packet(e),r={answer:s,bytes:0};return this.memory.set(t,r),s.then(a=>{r.bytes=a.bytes,this.held+=a.bytes;for(let[o,l]of this.memory){if(this.held<JR)break;l!==r&&l.bytes>0&&(this.memory.delete(o),this.held-=l.bytes)}},()=>this.memory.delete(t)),s}};function Yf(n,e){return n&&e?[Math.min(n[0],e[0]),Math.max(n[1],e[1])]:n??e}function Lr(n){return n instanceof Dn?{what:n.what,hint:n.hint}:{what:n instanceof Error?n.message:String(n),hint:"Reload the page."}}async function Ox(n,e,t,i){let{field:s,vectors:r,rangeMode:a}=t,{held:o}=n.summary,l=r==="contact force"||r==="seepage flow",c=(t.contacts||t.cracks||t.chains||l)&&(!o||o.contacts),h=r!==""&&!l&&n.hasField(r)&&(!o||o.vectors.includes(r)),u=Promise.resolve(null),f=s!==""&&n.hasField(s),d=t.cracks&&n.summary.cracks,p=t.bolts&&n.summary.bolts===!0,v=t.stress&&n.hasStress,m=(t.supports||t.chains)&&n.hasField("held"),g=t.joints==="interface"&&n.hasField("material"),[y,_,x,T,M,b,S,C,I,L]=await Promise.all([n.motion(e),f?n.field(e,s):u,f&&i&&(a==="run"||a==="most")&&!Pr.has(s)?KR(i,s,a):u,h?n.vectors(e,r):u,c?n.contacts(e):u,d?n.cracks(e).catch(()=>null):u,p?n.bolts(e).catch(()=>null):u,v?n.stress(e):u,m?n.field(e,"held").catch(()=>null):u,g?n.field(e,"material").catch(()=>null):u]);return{k:e,motion:y,field:_,range:x,vectors:T,contacts:M,cracks:b,bolts:S,stress:C,supports:I,materials:L}}async function KR(n,e,t){return(await Promise.all(n.map(s=>s.range(e)))).map(s=>t==="most"?s.most:s.range).reduce(Yf,null)}function jf(n,e){let{clipAxis:t,clipAt:i,clipDip:s,clipDirection:r,clipFlip:a,clipFlat:o}=e,l=n.dimension===2;if(t===""||t==="z"&&l)return null;let c=[0,0,0];t!=="free"?c["xyz".indexOf(t)]=1:c=l?yx(s):vx(s,r);let{low:h,high:u}=n.shape.info,f=[0,0];c.forEach((m,g)=>{f[0]+=Math.min(m*h[g],m*u[g]),f[1]+=Math.max(m*h[g],m*u[g])});let d=f[0]+i*(f[1]-f[0]),p=o?n.clearOf(c,d):d;return{normal:c,at:p,keep:(t==="z"||t==="free")===a?1:-1,flat:o}}function kx(n,e){let t=jf(n,e);if(!t)return null;let i=-t.keep;return{normal:t.normal.map(s=>i*s),at:i*Bx(n,t)}}function Bx(n,{normal:e,at:t}){let{origin:i}=n.shape.info;return t+e.reduce((s,r,a)=>s+r*i[a],0)}function zx(n,e){let t=jf(n,e);if(!t)return"";let{clipAxis:i,clipDip:s,clipDirection:r}=e;if(i!=="free")return`cut at ${i} = ${pn(Bx(n,t),"m",3)}`;let a=n.dimension===2,o=l=>String(Math.round(l)).padStart(a?1:2,"0");return a?`cut at ${o(s)}\xB0 from x`:`cut ${o(s)}\xB0/${o(r).padStart(3,"0")}\xB0 (dip/direction)`}var Hx={type:"change"},fg={type:"start"},Gx={type:"end"},Zf=new br,Vx=new Ai,QR=Math.cos(70*Kn.DEG2RAD),Hn=new P,Bi=2*Math.PI,Ut={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},ug=1e-6,Jf=class extends gc{constructor(e,t=null){super(e,t),this.state=Ut.NONE,this.target=new P,this.cursor=new P,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:cs.ROTATE,MIDDLE:cs.DOLLY,RIGHT:cs.PAN},this.touches={ONE:Es.ROTATE,TWO:Es.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new P,this._lastQuaternion=new Ci,this._lastTargetPosition=new P,this._quat=new Ci().setFromUnitVectors(e.up,new P(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new No,this._sphericalDelta=new No,this._scale=1,this._panOffset=new P,this._rotateStart=new Se,this._rotateEnd=new Se,this._rotateDelta=new Se,this._panStart=new Se,this._panEnd=new Se,this._panDelta=new Se,this._dollyStart=new Se,this._dollyEnd=new Se,this._dollyDelta=new Se,this._dollyDirection=new P,this._mouse=new Se,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=tC.bind(this),this._onPointerDown=eC.bind(this),this._onPointerUp=nC.bind(this),this._onContextMenu=cC.bind(this),this._onMouseWheel=rC.bind(this),this._onKeyDown=aC.bind(this),this._onTouchStart=oC.bind(this),this._onTouchMove=lC.bind(this),this._onMouseDown=iC.bind(this),this._onMouseMove=sC.bind(this),this._interceptControlDown=hC.bind(this),this._interceptControlUp=uC.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ut.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Hx),this.update(),this.state=Ut.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Hn.copy(t).sub(this.target),Hn.applyQuaternion(this._quat),this._spherical.setFromVector3(Hn),this.autoRotate&&this.state===Ut.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Bi:i>Math.PI&&(i-=Bi),s<-Math.PI?s+=Bi:s>Math.PI&&(s-=Bi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(Hn.setFromSpherical(this._spherical),Hn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Hn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){let o=Hn.length();a=this._clampDistance(o*this._scale);let l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let o=new P(this._mouse.x,this._mouse.y,0);o.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new P(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=Hn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(Zf.origin.copy(this.object.position),Zf.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Zf.direction))<QR?this.object.lookAt(this.target):(Vx.setFromNormalAndCoplanarPoint(this.object.up,this.target),Zf.intersectPlane(Vx,this.target))))}else if(this.object.isOrthographicCamera){let a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>ug||8*(1-this._lastQuaternion.dot(this.object.quaternion))>ug||this._lastTargetPosition.distanceToSquared(this.target)>ug?(this.dispatchEvent(Hx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Bi/60*this.autoRotateSpeed*e:Bi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Hn.setFromMatrixColumn(t,0),Hn.multiplyScalar(-e),this._panOffset.add(Hn)}_panUp(e,t){this.screenSpacePanning===!0?Hn.setFromMatrixColumn(t,1):(Hn.setFromMatrixColumn(t,0),Hn.crossVectors(this.object.up,Hn)),Hn.multiplyScalar(e),this._panOffset.add(Hn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Hn.copy(s).sub(this.target);let r=Hn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,a=i.width,o=i.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Bi*this._rotateDelta.x/t.clientHeight),this._rotateUp(Bi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Bi*this._rotateDelta.x/t.clientHeight),this._rotateUp(Bi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Se,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function eC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function tC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function nC(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Gx),this.state=Ut.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function iC(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case cs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ut.DOLLY;break;case cs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ut.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ut.ROTATE}break;case cs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ut.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ut.PAN}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(fg)}function sC(n){switch(this.state){case Ut.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ut.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ut.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function rC(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ut.NONE||(n.preventDefault(),this.dispatchEvent(fg),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Gx))}function aC(n){this.enabled!==!1&&this._handleKeyDown(n)}function oC(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Es.ROTATE:if(this.enableRotate===!1){this.state=Ut.NONE;break}this._handleTouchStartRotate(n),this.state=Ut.TOUCH_ROTATE;break;case Es.PAN:if(this.enablePan===!1){this.state=Ut.NONE;break}this._handleTouchStartPan(n),this.state=Ut.TOUCH_PAN;break;default:this.state=Ut.NONE}break;case 2:switch(this.touches.TWO){case Es.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ut.TOUCH_DOLLY_PAN;break;case Es.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ut.TOUCH_DOLLY_ROTATE;break;default:this.state=Ut.NONE}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(fg)}function lC(n){switch(this._trackPointer(n),this.state){case Ut.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ut.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ut.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ut.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ut.NONE}}function cC(n){this.enabled!==!1&&n.preventDefault()}function hC(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function uC(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var fC=[15e5,15e4],dC=2e4,pC=220,Kf=class{constructor(e,t){this.host=e;this.dimension=t;if(!document.createElement("canvas").getContext("webgl2"))throw new Dn("This browser does not support WebGL 2.","Switch on its hardware acceleration or try another browser. Without it, riprap shot RUN draws blocks in space and riprap plot RUN blocks those of the plane.");let i=mC();this.software=i,this.renderer=new Sf({antialias:!i,preserveDrawingBuffer:!0}),this.renderer.localClippingEnabled=!0,this.renderer.setPixelRatio(i?1:Math.min(window.devicePixelRatio,2)),this.canvas=this.renderer.domElement,this.canvas.tabIndex=0,this.canvas.setAttribute("aria-label","the blocks"),e.append(this.canvas),this.shading=new Bf(this.renderer,i),this.scene.add(this.sky,this.light,this.axes),this.camera=this.makeCamera(),this.controls=this.makeControls(),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}host;dimension;canvas;scene=new Vl;renderer;camera;controls;onMove=null;onDrawn=null;onDraw=null;standing=0;moving=!1;shadowed=null;shading;software;light=new fc(16777215,1.5);sky=new hc(16777215,13684944,1.35);due=!1;up="z";following=!1;axes=new Zt;box=new tn(new P(-1,-1,-1),new P(1,1,1));set background(e){this.scene.background=new qe(e),this.redraw()}setDimension(e,t){e===this.dimension&&t===this.up||(this.dimension=e,this.up=t,this.controls.dispose(),this.camera=this.makeCamera(),this.controls=this.makeControls(),this.resize())}makeCamera(){if(this.dimension===2)return new Zi(-1,1,1,-1,.1,1e3);let e=new En(32,1,.01,1e3);return e.up.set(0,this.up==="y"?1:0,this.up==="y"?0:1),e}makeControls(){let e=new Jf(this.camera,this.canvas);return e.zoomToCursor=!0,e.screenSpacePanning=!0,this.dimension===2&&(e.enableRotate=!1,e.mouseButtons={LEFT:cs.PAN,MIDDLE:cs.DOLLY,RIGHT:cs.PAN},e.touches={ONE:Es.PAN,TWO:Es.DOLLY_PAN}),e.addEventListener("change",()=>{this.moves(),this.redraw(),this.following||this.onMove?.(this.standpoint())}),e}moves(){let{shadowed:e}=this;!this.software||this.following||!e||e.visibleFaces<=dC||(this.moving=!0,clearTimeout(this.standing),this.standing=window.setTimeout(()=>{this.moving=!1,this.redraw()},pC))}stand(){clearTimeout(this.standing),this.moving=!1}standpoint(){return{position:this.camera.position.clone(),target:this.controls.target.clone(),zoom:this.camera.zoom}}follow(e){this.following=!0,this.camera.position.copy(e.position),this.controls.target.copy(e.target),this.camera.zoom=e.zoom,this.camera.updateProjectionMatrix(),this.controls.update(),this.following=!1,this.redraw()}look(e,t="default"){e.isEmpty()||(this.box=e.clone());let i=this.box.getCenter(new P),s=this.box.getSize(new P);if(this.controls.target.copy(i),this.camera.zoom=1,this.camera instanceof Zi)this.camera.position.set(i.x,i.y,i.z+100),this.frameOrthographic(s);else{let r={default:[-.55,.62,1],x:[1,0,0],y:[0,1,.001],z:[0,0,1]},a={default:[-.55,-1,.62],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},o=this.up==="y"?r:a,l=Math.max(1e-9,.5*s.length()),c=Kn.degToRad(this.camera.fov/2),h=Math.min(c,Math.atan(Math.tan(c)*this.camera.aspect)),u=new P(...o[t]).normalize().multiplyScalar(1.02*l/Math.sin(h));this.camera.position.copy(i).add(u),this.camera.near=l/200,this.camera.far=l*200}this.camera.updateProjectionMatrix(),this.controls.update(),this.stand(),this.redraw()}frameOrthographic(e){let t=this.camera,{clientWidth:i,clientHeight:s}=this.host,r=i>0&&s>0?i/s:1,a=.53*Math.max(e.y,e.x/r,1e-9);t.left=-a*r,t.right=a*r,t.top=a,t.bottom=-a}resize(){let{clientWidth:e,clientHeight:t}=this.host;e===0||t===0||(this.renderer.setSize(e,t,!1),this.camera instanceof En?this.camera.aspect=e/t:this.frameOrthographic(this.box.getSize(new P)),this.camera.updateProjectionMatrix(),this.draw())}redraw(){this.due||(this.due=!0,requestAnimationFrame(()=>{this.due&&this.draw()}))}draw(){this.due=!1;let e=this.up==="y"?new P(-1,1.5,.5):new P(-1,-.5,1.5);this.light.position.copy(e),this.sky.position.set(0,this.up==="y"?1:0,this.up==="y"?0:1),this.onDraw?.(this.metresPerPixel(),this.moving);let{shadowed:t,camera:i}=this;t?.isSolid&&!this.moving&&!this.tooMany(t)&&i instanceof En?this.shading.draw(t.solid,i,t.sphere,e,t.size):this.shading.clear(),this.renderer.render(this.scene,this.camera),this.onDrawn?.()}tooMany(e){return e.visibleFaces>fC[this.software?1:0]}ray(e,t){let i=this.canvas.getBoundingClientRect(),s=new Se(2*(e-i.left)/i.width-1,1-2*(t-i.top)/i.height),r=new pc;return r.setFromCamera(s,this.camera),r}onScreen(e){let t=this.canvas.getBoundingClientRect(),i=e.clone().project(this.camera);return[t.left+(.5+.5*i.x)*t.width,t.top+(.5-.5*i.y)*t.height]}triad(){let e=this.camera.quaternion.clone().invert();return[0,1,2].map(t=>{let i=new P().setComponent(t,1).applyQuaternion(e);return[i.x,i.y]})}metresPerPixel(){let e=Math.max(1,this.host.clientHeight);return this.camera instanceof Zi?(this.camera.top-this.camera.bottom)/this.camera.zoom/e:2*this.camera.position.distanceTo(this.controls.target)*Math.tan(Kn.degToRad(this.camera.fov/2))/e}};function mC(){let n=document.createElement("canvas").getContext("webgl2");if(!n)return!1;let e=n.getExtension("WEBGL_debug_renderer_info"),t=String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(t)}var gC=.5,Qf=class{object=new Zt;whole=new ed;fine=new ed;constructor(){this.object.add(this.whole.object,this.fine.object)}draw(e,t,i,s,r){if(this.whole.clear(),this.fine.clear(),!e)return null;let{longest:a,tetSize:o}=e.info,l=0;if(a!==null){let c=.9*t.size*s.vectorSize,h={longest:a,arms:e.f32("arms"),tension:e.u8("tension")};if(l=this.whole.draw(h,...vC(t,i,s,new Set(e.u32("tetBlock"))),c,Math.min(c/14,r)),o!==null){let u={longest:a,arms:e.f32("tetArms"),tension:e.u8("tetTension")},f=gC*o*s.vectorSize;l+=this.fine.draw(u,...yC(t,i,s,e),f,Math.min(f/10,r))}}return{...e.info,beyond:l}}},ed=class extends Go{draw({longest:e,arms:t,tension:i},s,r,a,o){this.clear();let l=Math.max(1,Math.ceil(s.length/eg)),c=s.filter((m,g)=>g%l===0),h=new _r(new Kr(1,1,1),this.material,3*c.length),u=new dn,f=new P,d=new qe,p=0;for(let m of c)for(let g=0;g<3;g++){let y=f.fromArray(t,9*m+3*g).length();y>.01*e&&(u.position.fromArray(r,3*m),u.quaternion.setFromUnitVectors(Wo,f.divideScalar(y)),u.scale.set(a*Math.min(1,y/e),o,o),u.updateMatrix(),h.setMatrixAt(p,u.matrix),h.setColorAt(p++,d.set(i[3*m+g]?Dc:Lc)))}h.count=p,h.frustumCulled=!1,h.renderOrder=4,this.mesh=h,this.object.add(h);let v=m=>[0,1,2].some(g=>f.fromArray(t,9*m+3*g).length()>1.001*e);return s.filter(v).length}};function vC(n,e,t,i){let s=n.dimension===2,r=new Float32Array(3*n.count),a=[],o=new P;for(let l=0;l<n.count;l++){e(l,o).multiplyScalar(t.exaggeration);for(let h=0;h<3;h++)r[3*l+h]=n.middles[3*l+h]+o.getComponent(h);let c=s||n.cutBlocks===0?!n.isAway(o.fromArray(r,3*l)):n.isCut(l);s&&(r[3*l+2]=.5),n.isShown(l)&&c&&Number.isFinite(o.x)&&!i.has(l)&&a.push(l)}return[a,r]}function yC(n,e,t,i){let[s,r]=[i.f32("tetCorners"),i.u32("tetBlock")],a=new Float32Array(3*r.length),o=[],[l,c,h]=[new P,new P,new P];return r.forEach((u,f)=>{if(u>=n.count||!n.isShown(u))return;e(u,h).multiplyScalar(t.exaggeration-1),c.set(0,0,0);let[d,p]=[0,0];for(;p<4;p++)l.fromArray(s,12*f+3*p).add(h),n.isAway(l)&&d++,c.addScaledVector(l,.25);c.toArray(a,3*f),(n.cutBlocks===0?d===0:d>0&&d<p)&&Number.isFinite(c.x)&&o.push(f)}),[o,a]}var dg=80;function pg(n){let e=JSON.parse(n).notes??[],t=i=>new Dn(`views.json: ${i}.`,"Save the file again from the viewer.");if(!Array.isArray(e))throw t("`notes` is no list");return e.map((i,s)=>{let{text:r,at:a,block:o}=i,l=Array.isArray(a)&&a.length===3&&a.every(c=>Number.isFinite(c));if(typeof r!="string"||!l)throw t(`note ${s+1} needs a text and a place \`at\``);return{text:r.slice(0,dg),at:a,block:typeof o=="number"?o:null}})}function Wx(n,e,t,i){let s=new P().fromArray(n.middles,3*e),r=t.f32("shifts"),a=new Ci,o=new P;if(n.dimension===2)o.set(r[2*e],r[2*e+1],0),a.setFromAxisAngle(new P(0,0,1),t.f32("turns")[e]);else{o.fromArray(r,3*e);let h=t.i16("turns"),[u,f,d]=[0,1,2].map(p=>h[3*e+p]*t.info.turnScale/32767);a.set(u,f,d,Math.sqrt(Math.max(0,1-u*u-f*f-d*d)))}let l=new nt().setFromMatrix4(new St().makeRotationFromQuaternion(a)),c=new nt;return l.elements.forEach((h,u)=>c.elements[u]=i*h+(u%4===0?1-i:0)),{turn:c,middle:s,shift:o.multiplyScalar(i)}}function bC(n,e,t,i){let s=new P(...n.at).sub(new P(...e.shape.info.origin));if(n.block===null)return s;let r=e.placeOf(n.block);if(r<0||!e.isShown(r))return null;let{turn:a,middle:o,shift:l}=Wx(e,r,t,i);return s.sub(o).applyMatrix3(a).add(o).add(l)}function Xx(n,e,t,i,s){return n.flatMap(r=>{let a=bC(r,e,t,i);if(!a||e.isAway(a))return[];let o=a.project(s);return Math.abs(o.x)<1&&Math.abs(o.y)<1&&o.z<1?[{text:r.text,x:.5+.5*o.x,y:.5-.5*o.y}]:[]})}function $x(n,e,t,i,s,r){let a=e.clone(),o=t===null?-1:i.placeOf(t);if(o>=0){let{turn:l,middle:c,shift:h}=Wx(i,o,s,r);a.sub(c).sub(h).applyMatrix3(l.invert()).add(c)}return a.add(new P(...i.shape.info.origin)),i.dimension===2&&(a.z=0),{text:n,at:a.toArray(),block:o>=0?t:null}}function qx(n){return n.map(({text:e,x:t,y:i})=>{let s=J("div.note-label",{},J("i"),J("span",{},e));return s.style.left=`${(100*t).toFixed(2)}%`,s.style.top=`${(100*i).toFixed(2)}%`,s})}function Yx(n,e,[t,i,s,r],a,[o,l]){n.font=`${12*a}px system-ui, sans-serif`,n.textBaseline="middle";for(let c of e){let[h,u]=[t+c.x*s,i+c.y*r],f=Math.min(n.measureText(c.text).width,s-12*a),d=Math.max(t+6*a,Math.min(h+14*a,t+s-f-6*a)),p=Math.max(u-18*a,i+11*a);n.strokeStyle=o,n.lineWidth=a,n.beginPath(),n.moveTo(h,u),n.lineTo(d,p),n.stroke(),n.fillStyle=l,n.fillRect(d-4*a,p-9*a,f+8*a,18*a),n.strokeRect(d-4*a,p-9*a,f+8*a,18*a),n.fillStyle=o,n.fillText(c.text,d,p,f),n.beginPath(),n.arc(h,u,2.5*a,0,2*Math.PI),n.fill()}}Le.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Se},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Ii.line={uniforms:Tc.merge([Le.common,Le.fog,Le.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var Xo=class extends Fi{constructor(e){super({type:"LineMaterial",uniforms:Tc.clone(Ii.line.uniforms),vertexShader:Ii.line.vertexShader,fragmentShader:Ii.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var jx=new tn,td=new P,$o=class extends dc{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new tt(e,3)),this.setAttribute("uv",new tt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new na(t,6,1);return this.setAttribute("instanceStart",new ws(i,3,0)),this.setAttribute("instanceEnd",new ws(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new na(t,6,1);return this.setAttribute("instanceColorStart",new ws(i,3,0)),this.setAttribute("instanceColorEnd",new ws(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new oc(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tn);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),jx.setFromBufferAttribute(t),this.boundingBox.union(jx))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new vi),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,a=e.count;r<a;r++)td.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(td)),td.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(td));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var mg=new Bt,Zx=new P,Jx=new P,li=new Bt,ci=new Bt,js=new Bt,gg=new P,vg=new St,hi=new mc,Kx=new P,nd=new tn,id=new vi,Zs=new Bt,Js,Ca;function Qx(n,e,t){return Zs.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),Zs.multiplyScalar(1/Zs.w),Zs.x=Ca/t.width,Zs.y=Ca/t.height,Zs.applyMatrix4(n.projectionMatrixInverse),Zs.multiplyScalar(1/Zs.w),Math.abs(Math.max(Zs.x,Zs.y))}function xC(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,a=Math.min(i.instanceCount,s.count);for(let o=0,l=a;o<l;o++){hi.start.fromBufferAttribute(s,o),hi.end.fromBufferAttribute(r,o),hi.applyMatrix4(t);let c=new P,h=new P;Js.distanceSqToSegment(hi.start,hi.end,h,c),h.distanceTo(c)<Ca*.5&&e.push({point:h,pointOnLine:c,distance:Js.origin.distanceTo(h),object:n,face:null,faceIndex:o,uv:null,uv1:null})}}function _C(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,a=n.matrixWorld,o=n.geometry,l=o.attributes.instanceStart,c=o.attributes.instanceEnd,h=Math.min(o.instanceCount,l.count),u=-e.near;Js.at(1,js),js.w=1,js.applyMatrix4(e.matrixWorldInverse),js.applyMatrix4(i),js.multiplyScalar(1/js.w),js.x*=r.x/2,js.y*=r.y/2,js.z=0,gg.copy(js),vg.multiplyMatrices(e.matrixWorldInverse,a);for(let f=0,d=h;f<d;f++){if(li.fromBufferAttribute(l,f),ci.fromBufferAttribute(c,f),li.w=1,ci.w=1,li.applyMatrix4(vg),ci.applyMatrix4(vg),li.z>u&&ci.z>u)continue;if(li.z>u){let _=li.z-ci.z,x=(li.z-u)/_;li.lerp(ci,x)}else if(ci.z>u){let _=ci.z-li.z,x=(ci.z-u)/_;ci.lerp(li,x)}li.applyMatrix4(i),ci.applyMatrix4(i),li.multiplyScalar(1/li.w),ci.multiplyScalar(1/ci.w),li.x*=r.x/2,li.y*=r.y/2,ci.x*=r.x/2,ci.y*=r.y/2,hi.start.copy(li),hi.start.z=0,hi.end.copy(ci),hi.end.z=0;let v=hi.closestPointToPointParameter(gg,!0);hi.at(v,Kx);let m=Kn.lerp(li.z,ci.z,v),g=m>=-1&&m<=1,y=gg.distanceTo(Kx)<Ca*.5;if(g&&y){hi.start.fromBufferAttribute(l,f),hi.end.fromBufferAttribute(c,f),hi.start.applyMatrix4(a),hi.end.applyMatrix4(a);let _=new P,x=new P;Js.distanceSqToSegment(hi.start,hi.end,x,_),t.push({point:x,pointOnLine:_,distance:Js.origin.distanceTo(x),object:n,face:null,faceIndex:f,uv:null,uv1:null})}}}var Uc=class extends zt{constructor(e=new $o,t=new Xo({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let a=0,o=0,l=t.count;a<l;a++,o+=2)Zx.fromBufferAttribute(t,a),Jx.fromBufferAttribute(i,a),s[o]=o===0?0:s[o-1],s[o+1]=s[o]+Zx.distanceTo(Jx);let r=new na(s,2,1);return e.setAttribute("instanceDistanceStart",new ws(r,1,0)),e.setAttribute("instanceDistanceEnd",new ws(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Js=e.ray;let a=this.matrixWorld,o=this.geometry,l=this.material;Ca=l.linewidth+r,o.boundingSphere===null&&o.computeBoundingSphere(),id.copy(o.boundingSphere).applyMatrix4(a);let c;if(i)c=Ca*.5;else{let u=Math.max(s.near,id.distanceToPoint(Js.origin));c=Qx(s,u,l.resolution)}if(id.radius+=c,Js.intersectsSphere(id)===!1)return;o.boundingBox===null&&o.computeBoundingBox(),nd.copy(o.boundingBox).applyMatrix4(a);let h;if(i)h=Ca*.5;else{let u=Math.max(s.near,nd.distanceToPoint(Js.origin));h=Qx(s,u,l.resolution)}nd.expandByScalar(h),Js.intersectsBox(nd)!==!1&&(i?xC(this,t):_C(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(mg),this.material.uniforms.resolution.value.set(mg.z,mg.w))}};var wC=.25,SC=1500,MC=3e7,EC=2.5,TC=2e4,sd=class{constructor(e,t,i){this.run=e;this.loading=t;this.software=i}run;loading;software;object=new Zt;material=new Xo({linewidth:EC,vertexColors:!0});thin=new Ui({vertexColors:!0});lines=null;upTo=[];ways=[];left=0;read="";drawn="";shown=null;key(e,t){return`${e} ${e==="picked"?t:""} ${this.run.frames} ${this.run.summary.manifest.started}`}has(e,t){return this.read===this.key(e,t)}async load(e,t){let{run:i,loading:s}=this,r=this.key(e,t),a=new Map,o=new Map,l=0,c=s.begin("Reading trails","frames",i.frames);try{for(let u=0;u<i.frames;u++){c.got=u;let f=await i.motion(u),d=await i.shape(f.info.shape,u),[p,v,m]=[d.u32("ids"),d.u32("offsets"),d.f32("points")];if(e==="moving"&&p.length*i.frames>MC)throw new Dn(`${p.length.toLocaleString("en")} blocks in ${i.frames} frames are too many for trails.`,"Pick a block and choose its trail alone.");let g=d.info.dimension,y=f.f32("shifts");l=wC*d.info.size,p.forEach((_,x)=>{if(e==="picked"&&_!==t)return;let T=[y[g*x],y[g*x+1],g===3?y[3*x+2]:0],M=Math.hypot(...T),b=a.get(_);b||(b={id:_,frames:[],middles:[],shifts:[]},a.set(_,b),o.set(_,-M)),Number.isFinite(M)&&(b.frames.push(u),b.shifts.push(...T),b.middles.push(...AC(m,v[x],v[x+1])),o.set(_,Math.max(o.get(_),M)))})}}finally{s.end(c)}let h=[...a.values()].filter(u=>e==="picked"||o.get(u.id)>l);h.sort((u,f)=>o.get(f.id)-o.get(u.id)||u.id-f.id),this.ways=h.slice(0,SC),this.left=h.length-this.ways.length,this.read=r,this.drawn=""}draw(e,t,i){let s=`${this.read} ${t} ${i}`;s!==this.drawn&&this.build(t,i),this.drawn=s;let r=this.upTo[Math.min(e,this.upTo.length-1)]??0;return this.lines instanceof Uc?this.lines.geometry.instanceCount=r:this.lines?.geometry.setDrawRange(0,2*r),this.object.visible=!0,this.shown}hide(){this.object.visible=!1}build(e,t){this.lines&&(this.object.remove(this.lines),this.lines.geometry.dispose(),this.lines=null);let i=this.run.summary.times,s=[];for(let{id:u,frames:f,middles:d,shifts:p}of this.ways)for(let v=1;v<f.length;v++){let m=T=>[0,1,2].map(M=>d[3*T+M]+e*p[3*T+M]),[g,y]=[m(v-1),m(v)],_=Math.hypot(...[0,1,2].map(T=>d[3*v+T]-d[3*v-3+T]+p[3*v+T]-p[3*v-3+T])),x=i[f[v]]-i[f[v-1]];s.push({frame:f[v],ends:[...g,...y],speed:x>0?_/x:0,id:u})}s.sort((u,f)=>u.frame-f.frame);let r=s.reduce((u,f)=>Math.max(u,f.speed),0);this.shown={count:this.ways.length,fastest:r,left:this.left},this.upTo=[];for(let{frame:u}of s)this.upTo[u]=(this.upTo[u]??0)+1;for(let u=0,f=0;u<this.run.frames;u++)this.upTo[u]=f+=this.upTo[u]??0;if(s.length===0)return;let a=new Float32Array(6*s.length);s.forEach((u,f)=>a.set(u.ends,6*f));let o=Aa.turbo,l=u=>t==="block"?Cr(u.id):o(.05+.9*u.speed/(r||1)),c=new qe,h=new Float32Array(6*s.length);if(s.forEach((u,f)=>{c.set(l(u)),h.set([c.r,c.g,c.b,c.r,c.g,c.b],6*f)}),this.software&&s.length>TC){let u=new vt;u.setAttribute("position",new ln(a,3)),u.setAttribute("color",new ln(h,3)),this.lines=new Ss(u,this.thin)}else{let u=new $o;u.setPositions(a),u.setColors(h),this.lines=new Uc(u,this.material)}this.lines.frustumCulled=!1,this.lines.renderOrder=3,s.every(u=>u.ends[2]===0&&u.ends[5]===0)&&(this.lines.position.z=.4),this.object.add(this.lines)}};function AC(n,e,t){let[i,s,r]=[0,0,0];for(let o=3*e;o<3*t;o+=3)i+=n[o],s+=n[o+1],r+=n[o+2];let a=Math.max(1,t-e);return[i/a,s/a,r/a]}function rd(n,e){let t=new Set,i=(s,r)=>{for(let a=s;a<=r;a++)t.add(a)};for(let[,s]of n.matchAll(/`([^`]+)`/g)){let[,r,a]=/^(.*)\.(\d+)$/.exec(s)??[];for(let o of e.blocks){let l=o.count??1;if(o.name===s)i(o.first,o.first+l-1);else if(o.from!==void 0&&o.name===r){let c=Number(a)-o.from;c>=0&&c<l&&i(o.first+c,o.first+c)}}for(let o of e.groups)if(o.name===s)for(let[l,c]of o.blocks)i(l,c)}return[...t].sort((s,r)=>s-r)}var ad="#e8a200",RC=2e3,CC=5e4,PC=9,od=class{constructor(e,t,i){this.run=e;this.host=t;this.loading=i;this.stage=new Kf(t,2),this.stage.onDraw=(s,r)=>this.blocks?.fade(s,r),this.trails=new sd(e,i,this.stage.software),this.stage.scene.add(this.trails.object),this.arrows={plane:new sa(!0),space:new sa(!1)},this.marks={plane:new Vo(!0),space:new Vo(!1)},this.warnedDots.frustumCulled=!1,this.warnedDots.renderOrder=4,this.stage.scene.add(this.warnedDots);for(let s of[...Object.values(this.arrows),...Object.values(this.marks),this.pickedMark,this.supportMark,this.drivenMark,this.warnedMark,this.bolts,this.chains,this.charges,this.stress,this.conditions,this.joints,this.ruler])this.stage.scene.add(s.object)}run;host;loading;stage;scale=new Af;blocks=null;frame=-1;motion=null;unit="";arrow=null;between=null;trouble=null;picked=null;values=null;arrows;marks;pickedMark=new Ra;supportMark=new Ra("#2f7bd9",3);drivenMark=new Ra("#e07b1a",3);warnedMark=new Ra(ad,4);warnedDots=new wr(new vt,new Ws({color:ad,size:10,sizeAttenuation:!1,depthTest:!1,transparent:!0}));bolts=new Lf;chains=new Df;charges=new Nf;stress=new Qf;conditions=new Gf;joints=new Vf;ruler=new Pf;ends=[];conditionNotes=[];warned=0;supports=null;driven=0;boltForces=null;chained=null;stressShown=null;last=null;atRest=new tn;ticket=0;ink="#000000";hasty=!1;trailed=null;notes=[];onChange=null;trails;now=null;others=[];get flat(){return this.blocks?.dimension!==3}get unshaded(){let{blocks:e,stage:t}=this;if(!e||e.dimension===2)return"";if(!e.isSolid)return"No shadows between blocks of glass.";let i=t.tooMany(e);return!i&&!e.crowded?"":`No ${[i?"shadows":"",e.crowded?"edges":""].filter(Boolean).join(" and ")}: ${e.visibleFaces.toLocaleString("en")} faces are too many ${t.software?"without graphics hardware":"for them"}.`}setTheme(e,t){this.stage.background=e;for(let i of Object.values(this.arrows))i.colour=t;this.ink=t,this.blocks?.tint(t),this.stage.redraw()}async show(e,t){let i=++this.ticket;if(this.run.frames===0)return!0;try{let s=await this.fetch(e,t);if(i!==this.ticket)return!1;let r=s.motion.info.shape;if(this.blocks?.shape.info.key!==r){let o=await this.run.shape(r,e);if(i!==this.ticket)return!1;let l=o.u32("ids").length,c=l>CC?await this.loading.announce(`Preparing ${l.toLocaleString("en")} blocks`):null;if(i===this.ticket&&this.build(new Hf(o,this.scale,this.stage.shading.lit,this.stage.software)),c&&this.loading.end(c),i!==this.ticket)return!1;let{conditions:h,blocks:u}={conditions:this.run.conditions,blocks:this.blocks};if(h&&u.ids.some(f=>f>=h.blocks)&&await this.run.readModel(),i!==this.ticket)return!1}let a=this.last===null;this.last=s,this.trouble=null,this.apply(t,!0),a&&this.blocks&&this.stage.look(this.blocks.box().union(this.atRest))}catch(s){if(i!==this.ticket)return!1;this.trouble=Lr(s)}return this.frame=e,!0}prefetch(e,t){return this.fetch(e,t).catch(()=>{})}fetch(e,t){return Ox(this.run,e,t,this.hasty?null:[this.run,...this.others])}build(e){let t=this.blocks===null,i=this.blocks;i&&(this.stage.scene.remove(i.object),i.dispose()),this.blocks=e,e.tint(this.ink);let s=this.run.summary.manifest.gravity??[0,0,0],r=e.dimension===3&&Math.abs(s[1])>Math.max(Math.abs(s[0]),Math.abs(s[2]))?"y":"z";this.stage.setDimension(e.dimension,r),this.stage.scene.add(e.object),t&&(this.charges.build(this.run.summary.manifest.sources??[],e.shape.info.origin,.3*e.size),this.atRest=e.box(),this.stage.look(this.atRest))}apply(e,t){let{last:i,blocks:s}=this;if(!i||!s)return;let r=this.look(e);this.motion=i.motion,t&&s.move(i.motion,r),this.values=i.field?.f32("values")??null,this.unit=i.field?.info.unit??"",this.tune(e),s.paint(this.values,this.scale),s.reveal(r,this.values),s.glass=(e.cracks||e.chains||e.joints!=="")&&!this.flat,this.stage.shadowed=e.shadows?s:null,this.stage.shading.moved();let{planes:a}=s;for(let l of Object.values(this.marks))l.end(a);this.charges.object.visible=e.charges,this.drawArrows(e),this.drawContacts(e),this.drawBolts(e),this.drawChains(e);let o=e.stress?i.stress:null;this.stressShown=this.stress.draw(o,s,(l,c)=>this.shiftOf(l,1,c),e,this.modelSize()/250),this.drawPicked(),this.drawWarned(),this.drawSupports(e),this.drawConditions(e),this.now=e,this.drawTrails(),this.stage.redraw()}async drawTrails(){let{trails:e,picked:t,now:i}=this;if(this.trailed=null,!i||i.trails===""||i.trails==="picked"&&t===null){e.hide();return}let s=i.trails;if(!e.has(s,t)){e.hide();try{await e.load(s,t)}catch(r){this.trouble=Lr(r)}e.has(s,t)&&this.now&&await this.drawTrails(),this.stage.redraw(),this.onChange?.();return}this.trailed=e.draw(this.last.k,i.exaggeration,i.trailColour)}labels(){let{blocks:e,motion:t,now:i,stage:s}=this;return!e||!t||!i?.notes?[]:Xx(this.notes,e,t,i.exaggeration,s.camera)}drawBolts(e){let t=e.bolts?this.last.bolts:null;if(this.boltForces=t?.info??null,!t){this.bolts.clear();return}let i=(s,r)=>this.shiftOf(s,e.exaggeration-1,r);this.bolts.draw(t,this.blocks,i,this.modelSize()/250)}drawChains(e){let t=e.chains?this.last.contacts:null;this.chained=null,this.chains.clear();let i=t?.info.longest??0;if(!t?.has("forces")||!(i>0))return;let s=this.blocks,r=this.contactPlaces(e),a=new P;for(let u=0;u<r.length;u+=3)s.isAway(a.fromArray(r,u))&&(r[u]=NaN);let o=u=>u>=s.count||!s.isShown(u)?null:this.shiftOf(u,e.exaggeration,new P).add(new P().fromArray(s.middles,3*u)),l=.015*this.modelSize()*e.vectorSize,c=this.last.supports?.f32("values"),h=this.chains.draw(t,r,o,u=>c&&c[u]>0?1/0:s.diagonal(u),l);this.chained={count:h,longest:i,unit:t.info.forceUnit??""}}drawSupports(e){let t=e.supports?this.last.supports?.f32("values"):void 0;if(this.supports=null,!t){this.supportMark.draw(null),this.drivenMark.draw(null);return}let i=[[],[]];this.supports=0,this.driven=0;let s=new Map((this.run.conditions?.supports??[]).flatMap(r=>r.blocks.map(a=>[a,r.driven])));t.forEach((r,a)=>{if(!(r>0))return;this.supports++;let o=s.get(this.blocks.ids[a])===!0;if(o&&this.driven++,this.blocks.isShown(a))for(let l of this.blocks.outline(a))i[o?1:0].push(l)}),this.supportMark.draw(new Float32Array(i[0])),this.drivenMark.draw(new Float32Array(i[1]))}drawConditions(e){let{conditions:t}=this.run,i=this.blocks,s=(a,o)=>this.shiftOf(a,e.exaggeration,o),r=a=>a?t:null;this.conditionNotes=[...this.conditions.drawFaces(r(e.boundaries),i),...this.conditions.drawLoads(r(e.loads),i,s,.1*this.modelSize()),...this.conditions.drawWater(r(e.water),i,this.last.motion.info.phase),...this.joints.draw(e.joints,i,t,this.last.materials?.f32("values")??null)]}look(e){return{exaggeration:e.exaggeration,edges:e.edges,clip:jf(this.blocks,e),only:e.only?[this.scale.low,this.scale.high]:null}}cutAway(e){return this.blocks&&kx(this.blocks,e)}cutText(e){return this.blocks?zx(this.blocks,e):""}tune(e){let{scale:t,last:i}=this;if(t.kinds=Pr.has(e.field),t.field=e.field,!this.values){t.kinds=!1,t.plain();return}let s=i?.field?.info,r=e.rangeMode==="most"?s?.most??s?.range:s?.range,[a,o]=(e.rangeMode==="frame"?r:i?.range??r)??[0,1];e.rangeMode==="fixed"?[a,o]=[e.low,e.high]:e.map==="blue-red"&&a<0&&o>0&&!e.log&&(o=Math.max(-a,o),a=-o),e.log&&(o=o>0?o:1,a=a>0?a:o*1e-6,a=Math.max(a,o*1e-9)),o>a||(o=a+(Math.abs(a)||1)*1e-6),t.low=a,t.high=o,t.log=e.log,t.paint(e.map)}shiftOf(e,t,i){let s=this.last.motion.f32("shifts");return this.flat?i.set(s[2*e],s[2*e+1],0):i.fromArray(s,3*e),i.multiplyScalar(t)}drawArrows(e){let{last:t,blocks:i}=this;this.arrow=null;let s=this.flat?this.arrows.plane:this.arrows.space,r=new P,a=.08*this.modelSize()*e.vectorSize,o=e.vectors==="seepage flow",l=o?"flows":"forces";if((o||e.vectors==="contact force")&&t.contacts?.has(l)){let c=t.contacts,h=(o?c.info.fastest:c.info.longest)??0,u=this.contactPlaces(e);for(let f=0;f<u.length;f+=3)i.isAway(r.fromArray(u,f))&&(u[f]=NaN);h>0?s.draw(u,c.f32(l),h,a):s.clear(),this.arrow={longest:h,unit:(o?c.info.flowUnit:c.info.forceUnit)??""}}else if(t.vectors){let c=new Float32Array(3*i.count),h=t.vectors.f32("values");for(let f=0;f<i.count;f++){this.shiftOf(f,e.exaggeration,r);for(let p=0;p<3;p++)c[3*f+p]=i.middles[3*f+p]+r.getComponent(p);(!i.isShown(f)||i.isAway(r.fromArray(c,3*f)))&&(c[3*f]=NaN)}let u=t.vectors.info.longest??0;u>0?s.draw(c,h,u,a):s.clear(),this.arrow={longest:u,unit:t.vectors.info.unit}}else s.clear()}modelSize(){let{low:e,high:t}=this.blocks.shape.info;return Math.hypot(t[0]-e[0],t[1]-e[1],t[2]-e[2])||1}contactPlaces(e){return dx(this.last.contacts,this.blocks,(t,i)=>this.shiftOf(t,e.exaggeration-1,i))}drawContacts(e){let t=this.last.contacts,i=this.flat?this.marks.plane:this.marks.space;if(this.between=t?{counts:Vo.count(t),areas:t.info.areas,unit:t.info.areaUnit}:null,t&&e.contacts?i.drawPoints(t,this.contactPlaces(e),e.states):i.hide("points"),t&&e.cracks&&!this.flat){let s=(r,a)=>this.shiftOf(r,e.exaggeration-1,a);i.drawCracks(t,this.last.cracks,this.blocks,s)}else i.hide("cracks")}drawPicked(){let e=this.picked===null?-1:this.blocks.placeOf(this.picked);this.pickedMark.draw(e<0?null:this.blocks.outline(e))}drawWarned(){let e=this.blocks,{preview:t,warnings:i}=this.run.summary.manifest,s=t?new Set(i.flatMap(c=>rd(c,this.run.names))):new Set;this.warned=s.size;let a=[...s].map(c=>e.placeOf(c)).filter(c=>c>=0&&e.isShown(c)).slice(0,RC),o=a.flatMap(c=>[...e.outline(c)]);this.warnedMark.draw(o.length>0?new Float32Array(o):null);let l=a.flatMap(c=>[...e.middles.subarray(3*c,3*c+2),this.flat?.6:e.middles[3*c+2]]);this.warnedDots.geometry.dispose(),this.warnedDots.geometry.setAttribute("position",new tt(l,3)),this.warnedDots.visible=l.length>0}goTo(e){let{blocks:t}=this;if(!t)return;let i=new tn;for(let s of e.map(r=>t.placeOf(r)))if(s>=0)for(let r of t.cornersOf(s))i.expandByPoint(r);i.isEmpty()||this.stage.look(i.expandByScalar(i.getSize(new P).length()))}pickAt(e,t){if(!this.blocks)return null;let i=this.blocks.pick(this.stage.ray(e,t));return i===null?null:this.blocks.ids[i]}placeAt(e,t){if(!this.blocks)return null;let i=this.stage.ray(e,t),s=this.blocks.hit(i),r=o=>{let[l,c]=this.stage.onScreen(o);return Math.hypot(l-e,c-t)},a=s?this.blocks.cornersOf(s.block).reduce((o,l)=>r(l)<r(o)?l:o):null;if(a&&r(a)<PC&&!this.blocks.isAway(a))return a;if(this.flat){let{origin:o,direction:l}=i.ray;return o.clone().addScaledVector(l,-o.z/l.z)}return s?.point??null}lay(e){this.ends=e,this.ruler.draw(e,this.flat),this.stage.redraw()}lineText(){let[e,t]=this.ends;if(!e)return"";if(!t)return"line: click its other end";let i=t.clone().sub(e),s=a=>qt(Math.abs(a)<1e-6*i.length()?0:a,4),r=(this.flat?[i.x,i.y]:i.toArray()).map(s).join(", ");return`distance ${pn(i.length(),"m",5)} (${r})`}along(){let[e,t]=this.ends;return!e||!t||!this.blocks?{pieces:[],length:0}:{pieces:ux(this.blocks,e,t).filter(i=>this.blocks.isShown(i.block)),length:e.distanceTo(t)}}pick(e){this.picked=e,this.blocks&&this.drawPicked(),this.now?.trails==="picked"&&this.drawTrails(),this.stage.redraw()}niceExaggeration(){let e=this.last?.motion.f32("shifts");if(!e)return 1;let t=this.flat?2:3,i=0;for(let a=0;a<e.length;a+=t)i=Math.max(i,Math.hypot(e[a],e[a+1],t===3?e[a+2]:0));if(!(i>0))return 1;let s=.05*this.modelSize()/i,r=10**Math.floor(Math.log10(s));return Math.max(1,r*Math.floor(s/r))}fit(e){this.blocks&&this.stage.look(this.blocks.box().union(this.conditions.reach),e)}};function ld(n,e){let{scale:t}=n,i={title:"",marks:[],kinds:t.kinds,notes:[]},s=n.blocks?.surveys??[];if(n.values&&e.field)if(t.kinds){i.title=e.field;let c=[...new Set(n.values)].filter(Number.isFinite).sort((h,u)=>h-u);if(c.length<=10){let h=e.field==="material"?s.map(f=>n.values[f]):[],u=f=>h.includes(f)?Rf:Cr(f,e.field);i.marks=c.map((f,d)=>({at:d,text:yg(n.run,e.field,f),colour:u(f)}))}}else{let c=Km(Math.max(Math.abs(t.low),Math.abs(t.high)),n.unit);i.title=e.field+(c.unit?` [${c.unit}]`:""),i.marks=IC(t,c.factor);let h=n.values.filter(u=>t.isBeyond(u)).length;h>0&&i.notes.push({text:`${h} block${h===1?"":"s"} beyond`})}s.length>0&&!t.kinds&&i.notes.push({text:"ground, without the field",colour:Rf}),n.warned>0&&i.notes.push({text:`${n.warned} block${n.warned===1?"":"s"} with warnings`,colour:ad}),n.supports!==null&&i.notes.push({text:`${n.supports} held or moved`,colour:"#2f7bd9"}),n.supports!==null&&n.driven>0&&i.notes.push({text:`${n.driven} of them driven`,colour:"#e07b1a"}),i.notes.push(...n.conditionNotes);let r=(n.run.summary.manifest.sources??[]).map(c=>c.name);if(e.charges&&r.length>0&&i.notes.push({text:r.length===1?`charge ${r[0]}`:`${r.length} charges`,colour:ng}),n.boltForces&&n.boltForces.largest!==null){let{largest:c,smallest:h,unit:u}=n.boltForces;i.notes.push({text:`bolts up to ${pn(c,u,3)}`,colour:"#d01c1c"}),h!==null&&h<0&&i.notes.push({text:`bolts down to ${pn(h,u,3)}`,colour:"#1d5fd0"})}if(n.chained){let{count:c,longest:h,unit:u}=n.chained;i.notes.push({text:`${c===1?"force of 1 contact":`forces of ${c} contacts`} up to ${pn(h,u,3)}`,colour:tg})}if(n.trailed){let{count:c,fastest:h,left:u}=n.trailed,f=`trail${c===1?"":"s"} of ${c} block${c===1?"":"s"}${u>0?` (${u} more)`:""}`;i.notes.push(e.trailColour==="speed"&&h>0?{text:`${f}, up to ${pn(h,"m/s",3)}`,colour:Aa.turbo(.95)}:{text:f})}if(n.stressShown?.range){let{range:[c,h],longest:u,unit:f,beyond:d}=n.stressShown;c<0&&i.notes.push({text:`compression up to ${pn(-c,f,3)}`,colour:Lc}),h>0&&i.notes.push({text:`tension up to ${pn(h,f,3)}`,colour:Dc}),u!==null&&i.notes.push({text:`longest cross ${pn(u,f,3)}${d>0?`, ${d} beyond`:""}`})}n.arrow&&e.vectors&&i.notes.push({text:`longest ${e.vectors} ${pn(n.arrow.longest,n.arrow.unit,3)}`}),e.exaggeration!==1&&i.notes.push({text:`displacements \xD7 ${qt(e.exaggeration)}`});let a=n.lineText();a&&i.notes.push({text:a,colour:Qm});let o=n.cutText(e);o&&i.notes.push({text:o});let{between:l}=n;return l&&(e.contacts||e.cracks)&&Ir.forEach((c,h)=>{let u=e.contacts&&e.states[h]||e.cracks&&!n.flat&&h>=Uf,f=l.counts[h];if(!u||f===0&&h>1)return;let d=l.unit==="m2"?"m\xB2":l.unit,p=h>=Uf?` (${qt(l.areas[h],3)} ${d})`:"";i.notes.push({text:`${c.name} ${f}${p}`,colour:c.colour})}),i}function yg(n,e,t){switch(e){case"block":return n.called(t);case"material":return n.summary.manifest.materials?.[t]??qt(t);case"held":return t>0?"held or driven":"free";case"surface":return t>0?"at the surface":"inside";case"removable_type":return["inside, or ground","key block","held by strength","held by weight","tapered"][t]??qt(t);case"removable_mode":return["not removable","stays","slides on one plane","slides on two planes","falls"][t]??qt(t);case"level":return t>0?`split ${qt(t)} times`:"not split";default:return qt(t)}}function IC(n,e){let{low:t,high:i}=n;if(n.log){let r=[],a=Math.ceil(Math.log10(t)-1e-9),o=Math.floor(Math.log10(i)+1e-9),l=Math.max(1,Math.ceil((o-a)/5));for(let c=a;c<=o;c+=l){let h=(c-Math.log10(t))/(Math.log10(i)-Math.log10(t));r.push({at:h,text:qt(10**c*e,3)})}return r}return hx(t*e,i*e,4).map(r=>({at:(r/e-t)/(i-t),text:qt(r,4)}))}function e_(n,e){let t=J("div.legend");if(n.title&&t.append(J("div.title",{},n.title)),n.kinds)for(let i of n.marks){let s=J("i.chip");s.style.background=i.colour??"",t.append(J("div.note",{},s,i.text))}else if(n.marks.length>0){let i=J("div.strip"),s=Array.from({length:17},(a,o)=>e.css(o/16));i.style.background=`linear-gradient(to top, ${s.join(",")})`;let r=J("div.scale",{},i);for(let a of n.marks){let o=J("span.tick",{},a.text);o.style.bottom=`${100*a.at}%`,r.append(o)}t.append(r)}for(let i of n.notes){let s=i.colour?J("i.chip"):null;s&&(s.style.background=i.colour),t.append(J("div.note",{},s,i.text))}return t}function t_(n,e,t,[i,s,r],a,o){n.textBaseline="middle",n.font=`600 ${12*a}px system-ui, sans-serif`,n.fillStyle=o;let l=s+10*a;e.title&&(n.fillText(e.title,i,l,r),l+=16*a),n.font=`${11*a}px system-ui, sans-serif`;let c=h=>{n.fillStyle=h,n.fillRect(i,l-5*a,10*a,10*a),n.fillStyle=o};if(e.kinds)for(let h of e.marks)c(h.colour??o),n.fillText(h.text,i+16*a,l,r-16*a),l+=15*a;else if(e.marks.length>0){let h=140*a,u=n.createLinearGradient(0,l+h,0,l);for(let f=0;f<=16;f++)u.addColorStop(f/16,t.css(f/16));n.fillStyle=u,n.fillRect(i,l,14*a,h),n.fillStyle=o;for(let f of e.marks)n.fillText(f.text,i+20*a,l+h*(1-f.at));l+=h+14*a}for(let h of e.notes){h.colour&&c(h.colour);let u=h.colour?16*a:0;n.fillText(h.text,i+u,l,r-u),l+=15*a}}var Cg=(n,e,t)=>{if(!e.has(n))throw TypeError("Cannot "+t)},W=(n,e,t)=>(Cg(n,e,"read from private field"),t?t.call(n):e.get(n)),bt=(n,e,t)=>{if(e.has(n))throw TypeError("Cannot add the same private member more than once");e instanceof WeakSet?e.add(n):e.set(n,t)},ei=(n,e,t,i)=>(Cg(n,e,"write to private field"),i?i.call(n,t):e.set(n,t),t),LC=(n,e,t,i)=>({set _(s){ei(n,e,s,t)},get _(){return W(n,e,i)}}),Tt=(n,e,t)=>(Cg(n,e,"access private method"),t),Ct=new Uint8Array(8),tr=new DataView(Ct.buffer),Vn=n=>[(n%256+256)%256],Ft=n=>(tr.setUint16(0,n,!1),[Ct[0],Ct[1]]),DC=n=>(tr.setInt16(0,n,!1),[Ct[0],Ct[1]]),i_=n=>(tr.setUint32(0,n,!1),[Ct[1],Ct[2],Ct[3]]),ke=n=>(tr.setUint32(0,n,!1),[Ct[0],Ct[1],Ct[2],Ct[3]]),NC=n=>(tr.setInt32(0,n,!1),[Ct[0],Ct[1],Ct[2],Ct[3]]),Ua=n=>(tr.setUint32(0,Math.floor(n/2**32),!1),tr.setUint32(4,n,!1),[Ct[0],Ct[1],Ct[2],Ct[3],Ct[4],Ct[5],Ct[6],Ct[7]]),Pg=n=>(tr.setInt16(0,2**8*n,!1),[Ct[0],Ct[1]]),Qs=n=>(tr.setInt32(0,2**16*n,!1),[Ct[0],Ct[1],Ct[2],Ct[3]]),bg=n=>(tr.setInt32(0,2**30*n,!1),[Ct[0],Ct[1],Ct[2],Ct[3]]),us=(n,e=!1)=>{let t=Array(n.length).fill(null).map((i,s)=>n.charCodeAt(s));return e&&t.push(0),t},pd=n=>n&&n[n.length-1],Ig=n=>{let e;for(let t of n)(!e||t.presentationTimestamp>e.presentationTimestamp)&&(e=t);return e},er=(n,e,t=!0)=>{let i=n*e;return t?Math.round(i):i},s_=n=>{let e=n*(Math.PI/180),t=Math.cos(e),i=Math.sin(e);return[t,i,0,-i,t,0,0,0,1]},r_=s_(0),a_=n=>[Qs(n[0]),Qs(n[1]),bg(n[2]),Qs(n[3]),Qs(n[4]),bg(n[5]),Qs(n[6]),Qs(n[7]),bg(n[8])],kc=n=>!n||typeof n!="object"?n:Array.isArray(n)?n.map(kc):Object.fromEntries(Object.entries(n).map(([e,t])=>[e,kc(t)])),Zo=n=>n>=0&&n<2**32,Nn=(n,e,t)=>({type:n,contents:e&&new Uint8Array(e.flat(10)),children:t}),cn=(n,e,t,i,s)=>Nn(n,[Vn(e),i_(t),i??[]],s),UC=n=>{let e=512;return n.fragmented?Nn("ftyp",[us("iso5"),ke(e),us("iso5"),us("iso6"),us("mp41")]):Nn("ftyp",[us("isom"),ke(e),us("isom"),n.holdsAvc?us("avc1"):[],us("mp41")])},xg=n=>({type:"mdat",largeSize:n}),FC=n=>({type:"free",size:n}),cd=(n,e,t=!1)=>Nn("moov",null,[OC(e,n),...n.map(i=>kC(i,e)),t?mP(n):null]),OC=(n,e)=>{let t=er(Math.max(0,...e.filter(a=>a.samples.length>0).map(a=>{let o=Ig(a.samples);return o.presentationTimestamp+o.duration})),Sg),i=Math.max(...e.map(a=>a.id))+1,s=!Zo(n)||!Zo(t),r=s?Ua:ke;return cn("mvhd",+s,0,[r(n),r(n),ke(Sg),r(t),Qs(1),Pg(1),Array(10).fill(0),a_(r_),Array(24).fill(0),ke(i)])},kC=(n,e)=>Nn("trak",null,[BC(n,e),zC(n,e)]),BC=(n,e)=>{let t=Ig(n.samples),i=er(t?t.presentationTimestamp+t.duration:0,Sg),s=!Zo(e)||!Zo(i),r=s?Ua:ke,a;return n.info.type==="video"?a=typeof n.info.rotation=="number"?s_(n.info.rotation):n.info.rotation:a=r_,cn("tkhd",+s,3,[r(e),r(e),ke(n.id),ke(0),r(i),Array(8).fill(0),Ft(0),Ft(0),Pg(n.info.type==="audio"?1:0),Ft(0),a_(a),Qs(n.info.type==="video"?n.info.width:0),Qs(n.info.type==="video"?n.info.height:0)])},zC=(n,e)=>Nn("mdia",null,[HC(n,e),VC(n.info.type==="video"?"vide":"soun"),GC(n)]),HC=(n,e)=>{let t=Ig(n.samples),i=er(t?t.presentationTimestamp+t.duration:0,n.timescale),s=!Zo(e)||!Zo(i),r=s?Ua:ke;return cn("mdhd",+s,0,[r(e),r(e),ke(n.timescale),r(i),Ft(21956),Ft(0)])},VC=n=>cn("hdlr",0,0,[us("mhlr"),us(n),ke(0),ke(0),ke(0),us("mp4-muxer-hdlr",!0)]),GC=n=>Nn("minf",null,[n.info.type==="video"?WC():XC(),$C(),jC(n)]),WC=()=>cn("vmhd",0,1,[Ft(0),Ft(0),Ft(0),Ft(0)]),XC=()=>cn("smhd",0,0,[Ft(0),Ft(0)]),$C=()=>Nn("dinf",null,[qC()]),qC=()=>cn("dref",0,0,[ke(1)],[YC()]),YC=()=>cn("url ",0,1),jC=n=>{let e=n.compositionTimeOffsetTable.length>1||n.compositionTimeOffsetTable.some(t=>t.sampleCompositionTimeOffset!==0);return Nn("stbl",null,[ZC(n),cP(n),hP(n),uP(n),fP(n),dP(n),e?pP(n):null])},ZC=n=>cn("stsd",0,0,[ke(1)],[n.info.type==="video"?JC(EP[n.info.codec],n):aP(AP[n.info.codec],n)]),JC=(n,e)=>Nn(n,[Array(6).fill(0),Ft(1),Ft(0),Ft(0),Array(12).fill(0),Ft(e.info.width),Ft(e.info.height),ke(4718592),ke(4718592),ke(0),Ft(1),Array(32).fill(0),Ft(24),DC(65535)],[TP[e.info.codec](e),e.info.decoderConfig.colorSpace?tP(e):null]),KC={bt709:1,bt470bg:5,smpte170m:6},QC={bt709:1,smpte170m:6,"iec61966-2-1":13},eP={rgb:0,bt709:1,bt470bg:5,smpte170m:6},tP=n=>Nn("colr",[us("nclx"),Ft(KC[n.info.decoderConfig.colorSpace.primaries]),Ft(QC[n.info.decoderConfig.colorSpace.transfer]),Ft(eP[n.info.decoderConfig.colorSpace.matrix]),Vn((n.info.decoderConfig.colorSpace.fullRange?1:0)<<7)]),nP=n=>n.info.decoderConfig&&Nn("avcC",[...new Uint8Array(n.info.decoderConfig.description)]),iP=n=>n.info.decoderConfig&&Nn("hvcC",[...new Uint8Array(n.info.decoderConfig.description)]),sP=n=>{if(!n.info.decoderConfig)return null;let e=n.info.decoderConfig;if(!e.colorSpace)throw new Error("'colorSpace' is required in the decoder config for VP9.");let t=e.codec.split("."),i=Number(t[1]),s=Number(t[2]),o=(Number(t[3])<<4)+(0<<1)+Number(e.colorSpace.fullRange);return cn("vpcC",1,0,[Vn(i),Vn(s),Vn(o),Vn(2),Vn(2),Vn(2),Ft(0)])},rP=()=>{let t=(1<<7)+1;return Nn("av1C",[t,0,0,0])},aP=(n,e)=>Nn(n,[Array(6).fill(0),Ft(1),Ft(0),Ft(0),ke(0),Ft(e.info.numberOfChannels),Ft(16),Ft(0),Ft(0),Qs(e.info.sampleRate)],[RP[e.info.codec](e)]),oP=n=>{let e=new Uint8Array(n.info.decoderConfig.description);return cn("esds",0,0,[ke(58753152),Vn(32+e.byteLength),Ft(1),Vn(0),ke(75530368),Vn(18+e.byteLength),Vn(64),Vn(21),i_(0),ke(130071),ke(130071),ke(92307584),Vn(e.byteLength),...e,ke(109084800),Vn(1),Vn(2)])},lP=n=>{let e=3840,t=0,i=n.info.decoderConfig?.description;if(i){if(i.byteLength<18)throw new TypeError("Invalid decoder description provided for Opus; must be at least 18 bytes long.");let s=ArrayBuffer.isView(i)?new DataView(i.buffer,i.byteOffset,i.byteLength):new DataView(i);e=s.getUint16(10,!0),t=s.getInt16(14,!0)}return Nn("dOps",[Vn(0),Vn(n.info.numberOfChannels),Ft(e),ke(n.info.sampleRate),Pg(t),Vn(0)])},cP=n=>cn("stts",0,0,[ke(n.timeToSampleTable.length),n.timeToSampleTable.map(e=>[ke(e.sampleCount),ke(e.sampleDelta)])]),hP=n=>{if(n.samples.every(t=>t.type==="key"))return null;let e=[...n.samples.entries()].filter(([,t])=>t.type==="key");return cn("stss",0,0,[ke(e.length),e.map(([t])=>ke(t+1))])},uP=n=>cn("stsc",0,0,[ke(n.compactlyCodedChunkTable.length),n.compactlyCodedChunkTable.map(e=>[ke(e.firstChunk),ke(e.samplesPerChunk),ke(1)])]),fP=n=>cn("stsz",0,0,[ke(0),ke(n.samples.length),n.samples.map(e=>ke(e.size))]),dP=n=>n.finalizedChunks.length>0&&pd(n.finalizedChunks).offset>=2**32?cn("co64",0,0,[ke(n.finalizedChunks.length),n.finalizedChunks.map(e=>Ua(e.offset))]):cn("stco",0,0,[ke(n.finalizedChunks.length),n.finalizedChunks.map(e=>ke(e.offset))]),pP=n=>cn("ctts",0,0,[ke(n.compositionTimeOffsetTable.length),n.compositionTimeOffsetTable.map(e=>[ke(e.sampleCount),ke(e.sampleCompositionTimeOffset)])]),mP=n=>Nn("mvex",null,n.map(gP)),gP=n=>cn("trex",0,0,[ke(n.id),ke(1),ke(0),ke(0),ke(0)]),n_=(n,e)=>Nn("moof",null,[vP(n),...e.map(yP)]),vP=n=>cn("mfhd",0,0,[ke(n)]),o_=n=>{let e=0,t=0,i=0,s=0,r=n.type==="delta";return t|=+r,r?e|=1:e|=2,e<<24|t<<16|i<<8|s},yP=n=>Nn("traf",null,[bP(n),xP(n),_P(n)]),bP=n=>{let e=0;e|=8,e|=16,e|=32,e|=131072;let t=n.currentChunk.samples[1]??n.currentChunk.samples[0],i={duration:t.timescaleUnitsToNextSample,size:t.size,flags:o_(t)};return cn("tfhd",0,e,[ke(n.id),ke(i.duration),ke(i.size),ke(i.flags)])},xP=n=>cn("tfdt",1,0,[Ua(er(n.currentChunk.startTimestamp,n.timescale))]),_P=n=>{let e=n.currentChunk.samples.map(v=>v.timescaleUnitsToNextSample),t=n.currentChunk.samples.map(v=>v.size),i=n.currentChunk.samples.map(o_),s=n.currentChunk.samples.map(v=>er(v.presentationTimestamp-v.decodeTimestamp,n.timescale)),r=new Set(e),a=new Set(t),o=new Set(i),l=new Set(s),c=o.size===2&&i[0]!==i[1],h=r.size>1,u=a.size>1,f=!c&&o.size>1,d=l.size>1||[...l].some(v=>v!==0),p=0;return p|=1,p|=4*+c,p|=256*+h,p|=512*+u,p|=1024*+f,p|=2048*+d,cn("trun",1,p,[ke(n.currentChunk.samples.length),ke(n.currentChunk.offset-n.currentChunk.moofOffset||0),c?ke(i[0]):[],n.currentChunk.samples.map((v,m)=>[h?ke(e[m]):[],u?ke(t[m]):[],f?ke(i[m]):[],d?NC(s[m]):[]])])},wP=n=>Nn("mfra",null,[...n.map(SP),MP()]),SP=(n,e)=>cn("tfra",1,0,[ke(n.id),ke(63),ke(n.finalizedChunks.length),n.finalizedChunks.map(i=>[Ua(er(i.startTimestamp,n.timescale)),Ua(i.moofOffset),ke(e+1),ke(1),ke(1)])]),MP=()=>cn("mfro",0,0,[ke(0)]),EP={avc:"avc1",hevc:"hvc1",vp9:"vp09",av1:"av01"},TP={avc:nP,hevc:iP,vp9:sP,av1:rP},AP={aac:"mp4a",opus:"Opus"},RP={aac:oP,opus:lP};var xd=class{},Lg=class extends xd{constructor(){super(...arguments),this.buffer=null}},l_=class extends xd{constructor(n){if(super(),this.options=n,typeof n!="object")throw new TypeError("StreamTarget requires an options object to be passed to its constructor.");if(n.onData){if(typeof n.onData!="function")throw new TypeError("options.onData, when provided, must be a function.");if(n.onData.length<2)throw new TypeError("options.onData, when provided, must be a function that takes in at least two arguments (data and position). Ignoring the position argument, which specifies the byte offset at which the data is to be written, can lead to broken outputs.")}if(n.chunked!==void 0&&typeof n.chunked!="boolean")throw new TypeError("options.chunked, when provided, must be a boolean.");if(n.chunkSize!==void 0&&(!Number.isInteger(n.chunkSize)||n.chunkSize<1024))throw new TypeError("options.chunkSize, when provided, must be an integer and not smaller than 1024.")}},CP=class extends xd{constructor(n,e){if(super(),this.stream=n,this.options=e,!(n instanceof FileSystemWritableFileStream))throw new TypeError("FileSystemWritableFileStreamTarget requires a FileSystemWritableFileStream instance.");if(e!==void 0&&typeof e!="object")throw new TypeError("FileSystemWritableFileStreamTarget's options, when provided, must be an object.");if(e&&e.chunkSize!==void 0&&(!Number.isInteger(e.chunkSize)||e.chunkSize<=0))throw new TypeError("options.chunkSize, when provided, must be a positive integer")}},Pa,qo,c_=class{constructor(){this.pos=0,bt(this,Pa,new Uint8Array(8)),bt(this,qo,new DataView(W(this,Pa).buffer)),this.offsets=new WeakMap}seek(n){this.pos=n}writeU32(n){W(this,qo).setUint32(0,n,!1),this.write(W(this,Pa).subarray(0,4))}writeU64(n){W(this,qo).setUint32(0,Math.floor(n/2**32),!1),W(this,qo).setUint32(4,n,!1),this.write(W(this,Pa).subarray(0,8))}writeAscii(n){for(let e=0;e<n.length;e++)W(this,qo).setUint8(e%8,n.charCodeAt(e)),e%8===7&&this.write(W(this,Pa));n.length%8!==0&&this.write(W(this,Pa).subarray(0,n.length%8))}writeBox(n){if(this.offsets.set(n,this.pos),n.contents&&!n.children)this.writeBoxHeader(n,n.size??n.contents.byteLength+8),this.write(n.contents);else{let e=this.pos;if(this.writeBoxHeader(n,0),n.contents&&this.write(n.contents),n.children)for(let s of n.children)s&&this.writeBox(s);let t=this.pos,i=n.size??t-e;this.seek(e),this.writeBoxHeader(n,i),this.seek(t)}}writeBoxHeader(n,e){this.writeU32(n.largeSize?1:e),this.writeAscii(n.type),n.largeSize&&this.writeU64(e)}measureBoxHeader(n){return 8+(n.largeSize?8:0)}patchBox(n){let e=this.pos;this.seek(this.offsets.get(n)),this.writeBox(n),this.seek(e)}measureBox(n){if(n.contents&&!n.children)return this.measureBoxHeader(n)+n.contents.byteLength;{let e=this.measureBoxHeader(n);if(n.contents&&(e+=n.contents.byteLength),n.children)for(let t of n.children)t&&(e+=this.measureBox(t));return e}}};Pa=new WeakMap;qo=new WeakMap;var hd,Na,Gc,Fc,ud,_g,PP=class extends c_{constructor(n){super(),bt(this,ud),bt(this,hd,void 0),bt(this,Na,new ArrayBuffer(2**16)),bt(this,Gc,new Uint8Array(W(this,Na))),bt(this,Fc,0),ei(this,hd,n)}write(n){Tt(this,ud,_g).call(this,this.pos+n.byteLength),W(this,Gc).set(n,this.pos),this.pos+=n.byteLength,ei(this,Fc,Math.max(W(this,Fc),this.pos))}finalize(){Tt(this,ud,_g).call(this,this.pos),W(this,hd).buffer=W(this,Na).slice(0,Math.max(W(this,Fc),this.pos))}};hd=new WeakMap;Na=new WeakMap;Gc=new WeakMap;Fc=new WeakMap;ud=new WeakSet;_g=function(n){let e=W(this,Na).byteLength;for(;e<n;)e*=2;if(e===W(this,Na).byteLength)return;let t=new ArrayBuffer(e),i=new Uint8Array(t);i.set(W(this,Gc),0),ei(this,Na,t),ei(this,Gc,i)};var IP=2**24,LP=2,Bc,Ia,Oc,Nr,Qi,md,wg,Dg,h_,Ng,u_,zc,gd,Ug=class extends c_{constructor(n){super(),bt(this,md),bt(this,Dg),bt(this,Ng),bt(this,zc),bt(this,Bc,void 0),bt(this,Ia,[]),bt(this,Oc,void 0),bt(this,Nr,void 0),bt(this,Qi,[]),ei(this,Bc,n),ei(this,Oc,n.options?.chunked??!1),ei(this,Nr,n.options?.chunkSize??IP)}write(n){W(this,Ia).push({data:n.slice(),start:this.pos}),this.pos+=n.byteLength}flush(){if(W(this,Ia).length===0)return;let n=[],e=[...W(this,Ia)].sort((t,i)=>t.start-i.start);n.push({start:e[0].start,size:e[0].data.byteLength});for(let t=1;t<e.length;t++){let i=n[n.length-1],s=e[t];s.start<=i.start+i.size?i.size=Math.max(i.size,s.start+s.data.byteLength-i.start):n.push({start:s.start,size:s.data.byteLength})}for(let t of n){t.data=new Uint8Array(t.size);for(let i of W(this,Ia))t.start<=i.start&&i.start<t.start+t.size&&t.data.set(i.data,i.start-t.start);W(this,Oc)?(Tt(this,md,wg).call(this,t.data,t.start),Tt(this,zc,gd).call(this)):W(this,Bc).options.onData?.(t.data,t.start)}W(this,Ia).length=0}finalize(){W(this,Oc)&&Tt(this,zc,gd).call(this,!0)}};Bc=new WeakMap;Ia=new WeakMap;Oc=new WeakMap;Nr=new WeakMap;Qi=new WeakMap;md=new WeakSet;wg=function(n,e){let t=W(this,Qi).findIndex(o=>o.start<=e&&e<o.start+W(this,Nr));t===-1&&(t=Tt(this,Ng,u_).call(this,e));let i=W(this,Qi)[t],s=e-i.start,r=n.subarray(0,Math.min(W(this,Nr)-s,n.byteLength));i.data.set(r,s);let a={start:s,end:s+r.byteLength};if(Tt(this,Dg,h_).call(this,i,a),i.written[0].start===0&&i.written[0].end===W(this,Nr)&&(i.shouldFlush=!0),W(this,Qi).length>LP){for(let o=0;o<W(this,Qi).length-1;o++)W(this,Qi)[o].shouldFlush=!0;Tt(this,zc,gd).call(this)}r.byteLength<n.byteLength&&Tt(this,md,wg).call(this,n.subarray(r.byteLength),e+r.byteLength)};Dg=new WeakSet;h_=function(n,e){let t=0,i=n.written.length-1,s=-1;for(;t<=i;){let r=Math.floor(t+(i-t+1)/2);n.written[r].start<=e.start?(t=r+1,s=r):i=r-1}for(n.written.splice(s+1,0,e),(s===-1||n.written[s].end<e.start)&&s++;s<n.written.length-1&&n.written[s].end>=n.written[s+1].start;)n.written[s].end=Math.max(n.written[s].end,n.written[s+1].end),n.written.splice(s+1,1)};Ng=new WeakSet;u_=function(n){let t={start:Math.floor(n/W(this,Nr))*W(this,Nr),data:new Uint8Array(W(this,Nr)),written:[],shouldFlush:!1};return W(this,Qi).push(t),W(this,Qi).sort((i,s)=>i.start-s.start),W(this,Qi).indexOf(t)};zc=new WeakSet;gd=function(n=!1){for(let e=0;e<W(this,Qi).length;e++){let t=W(this,Qi)[e];if(!(!t.shouldFlush&&!n)){for(let i of t.written)W(this,Bc).options.onData?.(t.data.subarray(i.start,i.end),t.start+i.start);W(this,Qi).splice(e--,1)}}};var DP=class extends Ug{constructor(n){super(new l_({onData:(e,t)=>n.stream.write({type:"write",data:e,position:t}),chunked:!0,chunkSize:n.options?.chunkSize}))}},Sg=1e3,NP=["avc","hevc","vp9","av1"],UP=["aac","opus"],FP=2082844800,OP=["strict","offset","cross-track-offset"],je,at,vd,Ki,ui,Qn,Yo,jo,Fg,La,Da,Hc,Mg,f_,Eg,d_,Og,p_,Tg,m_,kg,g_,fd,Ag,Ks,Dr,Bg,v_,Vc,yd,bd,zg,Jo,Wc,dd,Rg,y_=class{constructor(n){if(bt(this,Mg),bt(this,Eg),bt(this,Og),bt(this,Tg),bt(this,kg),bt(this,fd),bt(this,Ks),bt(this,Bg),bt(this,Vc),bt(this,bd),bt(this,Jo),bt(this,dd),bt(this,je,void 0),bt(this,at,void 0),bt(this,vd,void 0),bt(this,Ki,void 0),bt(this,ui,null),bt(this,Qn,null),bt(this,Yo,Math.floor(Date.now()/1e3)+FP),bt(this,jo,[]),bt(this,Fg,1),bt(this,La,[]),bt(this,Da,[]),bt(this,Hc,!1),Tt(this,Mg,f_).call(this,n),n.video=kc(n.video),n.audio=kc(n.audio),n.fastStart=kc(n.fastStart),this.target=n.target,ei(this,je,{firstTimestampBehavior:"strict",...n}),n.target instanceof Lg)ei(this,at,new PP(n.target));else if(n.target instanceof l_)ei(this,at,new Ug(n.target));else if(n.target instanceof CP)ei(this,at,new DP(n.target));else throw new Error(`Invalid target: ${n.target}`);Tt(this,Tg,m_).call(this),Tt(this,Eg,d_).call(this)}addVideoChunk(n,e,t,i){if(!(n instanceof EncodedVideoChunk))throw new TypeError("addVideoChunk's first argument (sample) must be of type EncodedVideoChunk.");if(e&&typeof e!="object")throw new TypeError("addVideoChunk's second argument (meta), when provided, must be an object.");if(t!==void 0&&(!Number.isFinite(t)||t<0))throw new TypeError("addVideoChunk's third argument (timestamp), when provided, must be a non-negative real number.");if(i!==void 0&&!Number.isFinite(i))throw new TypeError("addVideoChunk's fourth argument (compositionTimeOffset), when provided, must be a real number.");let s=new Uint8Array(n.byteLength);n.copyTo(s),this.addVideoChunkRaw(s,n.type,t??n.timestamp,n.duration,e,i)}addVideoChunkRaw(n,e,t,i,s,r){if(!(n instanceof Uint8Array))throw new TypeError("addVideoChunkRaw's first argument (data) must be an instance of Uint8Array.");if(e!=="key"&&e!=="delta")throw new TypeError("addVideoChunkRaw's second argument (type) must be either 'key' or 'delta'.");if(!Number.isFinite(t)||t<0)throw new TypeError("addVideoChunkRaw's third argument (timestamp) must be a non-negative real number.");if(!Number.isFinite(i)||i<0)throw new TypeError("addVideoChunkRaw's fourth argument (duration) must be a non-negative real number.");if(s&&typeof s!="object")throw new TypeError("addVideoChunkRaw's fifth argument (meta), when provided, must be an object.");if(r!==void 0&&!Number.isFinite(r))throw new TypeError("addVideoChunkRaw's sixth argument (compositionTimeOffset), when provided, must be a real number.");if(Tt(this,dd,Rg).call(this),!W(this,je).video)throw new Error("No video track declared.");if(typeof W(this,je).fastStart=="object"&&W(this,ui).samples.length===W(this,je).fastStart.expectedVideoChunks)throw new Error(`Cannot add more video chunks than specified in 'fastStart' (${W(this,je).fastStart.expectedVideoChunks}).`);let a=Tt(this,fd,Ag).call(this,W(this,ui),n,e,t,i,s,r);if(W(this,je).fastStart==="fragmented"&&W(this,Qn)){for(;W(this,Da).length>0&&W(this,Da)[0].decodeTimestamp<=a.decodeTimestamp;){let o=W(this,Da).shift();Tt(this,Ks,Dr).call(this,W(this,Qn),o)}a.decodeTimestamp<=W(this,Qn).lastDecodeTimestamp?Tt(this,Ks,Dr).call(this,W(this,ui),a):W(this,La).push(a)}else Tt(this,Ks,Dr).call(this,W(this,ui),a)}addAudioChunk(n,e,t){if(!(n instanceof EncodedAudioChunk))throw new TypeError("addAudioChunk's first argument (sample) must be of type EncodedAudioChunk.");if(e&&typeof e!="object")throw new TypeError("addAudioChunk's second argument (meta), when provided, must be an object.");if(t!==void 0&&(!Number.isFinite(t)||t<0))throw new TypeError("addAudioChunk's third argument (timestamp), when provided, must be a non-negative real number.");let i=new Uint8Array(n.byteLength);n.copyTo(i),this.addAudioChunkRaw(i,n.type,t??n.timestamp,n.duration,e)}addAudioChunkRaw(n,e,t,i,s){if(!(n instanceof Uint8Array))throw new TypeError("addAudioChunkRaw's first argument (data) must be an instance of Uint8Array.");if(e!=="key"&&e!=="delta")throw new TypeError("addAudioChunkRaw's second argument (type) must be either 'key' or 'delta'.");if(!Number.isFinite(t)||t<0)throw new TypeError("addAudioChunkRaw's third argument (timestamp) must be a non-negative real number.");if(!Number.isFinite(i)||i<0)throw new TypeError("addAudioChunkRaw's fourth argument (duration) must be a non-negative real number.");if(s&&typeof s!="object")throw new TypeError("addAudioChunkRaw's fifth argument (meta), when provided, must be an object.");if(Tt(this,dd,Rg).call(this),!W(this,je).audio)throw new Error("No audio track declared.");if(typeof W(this,je).fastStart=="object"&&W(this,Qn).samples.length===W(this,je).fastStart.expectedAudioChunks)throw new Error(`Cannot add more audio chunks than specified in 'fastStart' (${W(this,je).fastStart.expectedAudioChunks}).`);let r=Tt(this,fd,Ag).call(this,W(this,Qn),n,e,t,i,s);if(W(this,je).fastStart==="fragmented"&&W(this,ui)){for(;W(this,La).length>0&&W(this,La)[0].decodeTimestamp<=r.decodeTimestamp;){let a=W(this,La).shift();Tt(this,Ks,Dr).call(this,W(this,ui),a)}r.decodeTimestamp<=W(this,ui).lastDecodeTimestamp?Tt(this,Ks,Dr).call(this,W(this,Qn),r):W(this,Da).push(r)}else Tt(this,Ks,Dr).call(this,W(this,Qn),r)}finalize(){if(W(this,Hc))throw new Error("Cannot finalize a muxer more than once.");if(W(this,je).fastStart==="fragmented"){for(let e of W(this,La))Tt(this,Ks,Dr).call(this,W(this,ui),e);for(let e of W(this,Da))Tt(this,Ks,Dr).call(this,W(this,Qn),e);Tt(this,bd,zg).call(this,!1)}else W(this,ui)&&Tt(this,Vc,yd).call(this,W(this,ui)),W(this,Qn)&&Tt(this,Vc,yd).call(this,W(this,Qn));let n=[W(this,ui),W(this,Qn)].filter(Boolean);if(W(this,je).fastStart==="in-memory"){let e;for(let i=0;i<2;i++){let s=cd(n,W(this,Yo)),r=W(this,at).measureBox(s);e=W(this,at).measureBox(W(this,Ki));let a=W(this,at).pos+r+e;for(let o of W(this,jo)){o.offset=a;for(let{data:l}of o.samples)a+=l.byteLength,e+=l.byteLength}if(a<2**32)break;e>=2**32&&(W(this,Ki).largeSize=!0)}let t=cd(n,W(this,Yo));W(this,at).writeBox(t),W(this,Ki).size=e,W(this,at).writeBox(W(this,Ki));for(let i of W(this,jo))for(let s of i.samples)W(this,at).write(s.data),s.data=null}else if(W(this,je).fastStart==="fragmented"){let e=W(this,at).pos,t=wP(n);W(this,at).writeBox(t);let i=W(this,at).pos-e;W(this,at).seek(W(this,at).pos-4),W(this,at).writeU32(i)}else{let e=W(this,at).offsets.get(W(this,Ki)),t=W(this,at).pos-e;W(this,Ki).size=t,W(this,Ki).largeSize=t>=2**32,W(this,at).patchBox(W(this,Ki));let i=cd(n,W(this,Yo));if(typeof W(this,je).fastStart=="object"){W(this,at).seek(W(this,vd)),W(this,at).writeBox(i);let s=e-W(this,at).pos;W(this,at).writeBox(FC(s))}else W(this,at).writeBox(i)}Tt(this,Jo,Wc).call(this),W(this,at).finalize(),ei(this,Hc,!0)}};je=new WeakMap;at=new WeakMap;vd=new WeakMap;Ki=new WeakMap;ui=new WeakMap;Qn=new WeakMap;Yo=new WeakMap;jo=new WeakMap;Fg=new WeakMap;La=new WeakMap;Da=new WeakMap;Hc=new WeakMap;Mg=new WeakSet;f_=function(n){if(typeof n!="object")throw new TypeError("The muxer requires an options object to be passed to its constructor.");if(!(n.target instanceof xd))throw new TypeError("The target must be provided and an instance of Target.");if(n.video){if(!NP.includes(n.video.codec))throw new TypeError(`Unsupported video codec: ${n.video.codec}`);if(!Number.isInteger(n.video.width)||n.video.width<=0)throw new TypeError(`Invalid video width: ${n.video.width}. Must be a positive integer.`);if(!Number.isInteger(n.video.height)||n.video.height<=0)throw new TypeError(`Invalid video height: ${n.video.height}. Must be a positive integer.`);let e=n.video.rotation;if(typeof e=="number"&&![0,90,180,270].includes(e))throw new TypeError(`Invalid video rotation: ${e}. Has to be 0, 90, 180 or 270.`);if(Array.isArray(e)&&(e.length!==9||e.some(t=>typeof t!="number")))throw new TypeError(`Invalid video transformation matrix: ${e.join()}`);if(n.video.frameRate!==void 0&&(!Number.isInteger(n.video.frameRate)||n.video.frameRate<=0))throw new TypeError(`Invalid video frame rate: ${n.video.frameRate}. Must be a positive integer.`)}if(n.audio){if(!UP.includes(n.audio.codec))throw new TypeError(`Unsupported audio codec: ${n.audio.codec}`);if(!Number.isInteger(n.audio.numberOfChannels)||n.audio.numberOfChannels<=0)throw new TypeError(`Invalid number of audio channels: ${n.audio.numberOfChannels}. Must be a positive integer.`);if(!Number.isInteger(n.audio.sampleRate)||n.audio.sampleRate<=0)throw new TypeError(`Invalid audio sample rate: ${n.audio.sampleRate}. Must be a positive integer.`)}if(n.firstTimestampBehavior&&!OP.includes(n.firstTimestampBehavior))throw new TypeError(`Invalid first timestamp behavior: ${n.firstTimestampBehavior}`);if(typeof n.fastStart=="object"){if(n.video){if(n.fastStart.expectedVideoChunks===void 0)throw new TypeError("'fastStart' is an object but is missing property 'expectedVideoChunks'.");if(!Number.isInteger(n.fastStart.expectedVideoChunks)||n.fastStart.expectedVideoChunks<0)throw new TypeError("'expectedVideoChunks' must be a non-negative integer.")}if(n.audio){if(n.fastStart.expectedAudioChunks===void 0)throw new TypeError("'fastStart' is an object but is missing property 'expectedAudioChunks'.");if(!Number.isInteger(n.fastStart.expectedAudioChunks)||n.fastStart.expectedAudioChunks<0)throw new TypeError("'expectedAudioChunks' must be a non-negative integer.")}}else if(![!1,"in-memory","fragmented"].includes(n.fastStart))throw new TypeError("'fastStart' option must be false, 'in-memory', 'fragmented' or an object.");if(n.minFragmentDuration!==void 0&&(!Number.isFinite(n.minFragmentDuration)||n.minFragmentDuration<0))throw new TypeError("'minFragmentDuration' must be a non-negative number.")};Eg=new WeakSet;d_=function(){if(W(this,at).writeBox(UC({holdsAvc:W(this,je).video?.codec==="avc",fragmented:W(this,je).fastStart==="fragmented"})),ei(this,vd,W(this,at).pos),W(this,je).fastStart==="in-memory")ei(this,Ki,xg(!1));else if(W(this,je).fastStart!=="fragmented"){if(typeof W(this,je).fastStart=="object"){let n=Tt(this,Og,p_).call(this);W(this,at).seek(W(this,at).pos+n)}ei(this,Ki,xg(!0)),W(this,at).writeBox(W(this,Ki))}Tt(this,Jo,Wc).call(this)};Og=new WeakSet;p_=function(){if(typeof W(this,je).fastStart!="object")return;let n=0,e=[W(this,je).fastStart.expectedVideoChunks,W(this,je).fastStart.expectedAudioChunks];for(let t of e)t&&(n+=8*Math.ceil(2/3*t),n+=4*t,n+=12*Math.ceil(2/3*t),n+=4*t,n+=8*t);return n+=4096,n};Tg=new WeakSet;m_=function(){if(W(this,je).video&&ei(this,ui,{id:1,info:{type:"video",codec:W(this,je).video.codec,width:W(this,je).video.width,height:W(this,je).video.height,rotation:W(this,je).video.rotation??0,decoderConfig:null},timescale:W(this,je).video.frameRate??57600,samples:[],finalizedChunks:[],currentChunk:null,firstDecodeTimestamp:void 0,lastDecodeTimestamp:-1,timeToSampleTable:[],compositionTimeOffsetTable:[],lastTimescaleUnits:null,lastSample:null,compactlyCodedChunkTable:[]}),W(this,je).audio&&(ei(this,Qn,{id:W(this,je).video?2:1,info:{type:"audio",codec:W(this,je).audio.codec,numberOfChannels:W(this,je).audio.numberOfChannels,sampleRate:W(this,je).audio.sampleRate,decoderConfig:null},timescale:W(this,je).audio.sampleRate,samples:[],finalizedChunks:[],currentChunk:null,firstDecodeTimestamp:void 0,lastDecodeTimestamp:-1,timeToSampleTable:[],compositionTimeOffsetTable:[],lastTimescaleUnits:null,lastSample:null,compactlyCodedChunkTable:[]}),W(this,je).audio.codec==="aac")){let n=Tt(this,kg,g_).call(this,2,W(this,je).audio.sampleRate,W(this,je).audio.numberOfChannels);W(this,Qn).info.decoderConfig={codec:W(this,je).audio.codec,description:n,numberOfChannels:W(this,je).audio.numberOfChannels,sampleRate:W(this,je).audio.sampleRate}}};kg=new WeakSet;g_=function(n,e,t){let s=[96e3,88200,64e3,48e3,44100,32e3,24e3,22050,16e3,12e3,11025,8e3,7350].indexOf(e),r=t,a="";a+=n.toString(2).padStart(5,"0"),a+=s.toString(2).padStart(4,"0"),s===15&&(a+=e.toString(2).padStart(24,"0")),a+=r.toString(2).padStart(4,"0");let o=Math.ceil(a.length/8)*8;a=a.padEnd(o,"0");let l=new Uint8Array(a.length/8);for(let c=0;c<a.length;c+=8)l[c/8]=parseInt(a.slice(c,c+8),2);return l};fd=new WeakSet;Ag=function(n,e,t,i,s,r,a){let o=i/1e6,l=(i-(a??0))/1e6,c=s/1e6,h=Tt(this,Bg,v_).call(this,o,l,n);return o=h.presentationTimestamp,l=h.decodeTimestamp,r?.decoderConfig&&(n.info.decoderConfig===null?n.info.decoderConfig=r.decoderConfig:Object.assign(n.info.decoderConfig,r.decoderConfig)),{presentationTimestamp:o,decodeTimestamp:l,duration:c,data:e,size:e.byteLength,type:t,timescaleUnitsToNextSample:er(c,n.timescale)}};Ks=new WeakSet;Dr=function(n,e){W(this,je).fastStart!=="fragmented"&&n.samples.push(e);let t=er(e.presentationTimestamp-e.decodeTimestamp,n.timescale);if(n.lastTimescaleUnits!==null){let s=er(e.decodeTimestamp,n.timescale,!1),r=Math.round(s-n.lastTimescaleUnits);if(n.lastTimescaleUnits+=r,n.lastSample.timescaleUnitsToNextSample=r,W(this,je).fastStart!=="fragmented"){let a=pd(n.timeToSampleTable);a.sampleCount===1?(a.sampleDelta=r,a.sampleCount++):a.sampleDelta===r?a.sampleCount++:(a.sampleCount--,n.timeToSampleTable.push({sampleCount:2,sampleDelta:r}));let o=pd(n.compositionTimeOffsetTable);o.sampleCompositionTimeOffset===t?o.sampleCount++:n.compositionTimeOffsetTable.push({sampleCount:1,sampleCompositionTimeOffset:t})}}else n.lastTimescaleUnits=0,W(this,je).fastStart!=="fragmented"&&(n.timeToSampleTable.push({sampleCount:1,sampleDelta:er(e.duration,n.timescale)}),n.compositionTimeOffsetTable.push({sampleCount:1,sampleCompositionTimeOffset:t}));n.lastSample=e;let i=!1;if(!n.currentChunk)i=!0;else{let s=e.presentationTimestamp-n.currentChunk.startTimestamp;if(W(this,je).fastStart==="fragmented"){let r=W(this,ui)??W(this,Qn),a=W(this,je).minFragmentDuration??1;n===r&&e.type==="key"&&s>=a&&(i=!0,Tt(this,bd,zg).call(this))}else i=s>=.5}i&&(n.currentChunk&&Tt(this,Vc,yd).call(this,n),n.currentChunk={startTimestamp:e.presentationTimestamp,samples:[]}),n.currentChunk.samples.push(e)};Bg=new WeakSet;v_=function(n,e,t){let i=W(this,je).firstTimestampBehavior==="strict",s=t.lastDecodeTimestamp===-1;if(i&&s&&e!==0)throw new Error(`The first chunk for your media track must have a timestamp of 0 (received DTS=${e}).Non-zero first timestamps are often caused by directly piping frames or audio data from a MediaStreamTrack into the encoder. Their timestamps are typically relative to the age of thedocument, which is probably what you want.

If you want to offset all timestamps of a track such that the first one is zero, set firstTimestampBehavior: 'offset' in the options.
`);if(W(this,je).firstTimestampBehavior==="offset"||W(this,je).firstTimestampBehavior==="cross-track-offset"){t.firstDecodeTimestamp===void 0&&(t.firstDecodeTimestamp=e);let a;W(this,je).firstTimestampBehavior==="offset"?a=t.firstDecodeTimestamp:a=Math.min(W(this,ui)?.firstDecodeTimestamp??1/0,W(this,Qn)?.firstDecodeTimestamp??1/0),e-=a,n-=a}if(e<t.lastDecodeTimestamp)throw new Error(`Timestamps must be monotonically increasing (DTS went from ${t.lastDecodeTimestamp*1e6} to ${e*1e6}).`);return t.lastDecodeTimestamp=e,{presentationTimestamp:n,decodeTimestamp:e}};Vc=new WeakSet;yd=function(n){if(W(this,je).fastStart==="fragmented")throw new Error("Can't finalize individual chunks if 'fastStart' is set to 'fragmented'.");if(n.currentChunk){if(n.finalizedChunks.push(n.currentChunk),W(this,jo).push(n.currentChunk),(n.compactlyCodedChunkTable.length===0||pd(n.compactlyCodedChunkTable).samplesPerChunk!==n.currentChunk.samples.length)&&n.compactlyCodedChunkTable.push({firstChunk:n.finalizedChunks.length,samplesPerChunk:n.currentChunk.samples.length}),W(this,je).fastStart==="in-memory"){n.currentChunk.offset=0;return}n.currentChunk.offset=W(this,at).pos;for(let e of n.currentChunk.samples)W(this,at).write(e.data),e.data=null;Tt(this,Jo,Wc).call(this)}};bd=new WeakSet;zg=function(n=!0){if(W(this,je).fastStart!=="fragmented")throw new Error("Can't finalize a fragment unless 'fastStart' is set to 'fragmented'.");let e=[W(this,ui),W(this,Qn)].filter(o=>o&&o.currentChunk);if(e.length===0)return;let t=LC(this,Fg)._++;if(t===1){let o=cd(e,W(this,Yo),!0);W(this,at).writeBox(o)}let i=W(this,at).pos,s=n_(t,e);W(this,at).writeBox(s);{let o=xg(!1),l=0;for(let h of e)for(let u of h.currentChunk.samples)l+=u.size;let c=W(this,at).measureBox(o)+l;c>=2**32&&(o.largeSize=!0,c=W(this,at).measureBox(o)+l),o.size=c,W(this,at).writeBox(o)}for(let o of e){o.currentChunk.offset=W(this,at).pos,o.currentChunk.moofOffset=i;for(let l of o.currentChunk.samples)W(this,at).write(l.data),l.data=null}let r=W(this,at).pos;W(this,at).seek(W(this,at).offsets.get(s));let a=n_(t,e);W(this,at).writeBox(a),W(this,at).seek(r);for(let o of e)o.finalizedChunks.push(o.currentChunk),W(this,jo).push(o.currentChunk),o.currentChunk=null;n&&Tt(this,Jo,Wc).call(this)};Jo=new WeakSet;Wc=function(){W(this,at)instanceof Ug&&W(this,at).flush()};dd=new WeakSet;Rg=function(){if(W(this,Hc))throw new Error("Cannot add new video or audio chunks after the file has been finalized.")};/*! mp4-muxer 5.2.2, Copyright (c) 2023 Vanilagy, MIT License */function b_(n){let{width:e,height:t,codec:i,framesPerSecond:s,frames:r,decoder:a}=n,o=new Lg,l=new y_({target:o,video:{codec:i,width:e,height:t,frameRate:s},fastStart:"in-memory"}),c=h=>Math.round(1e6*h/s);return r.forEach(({data:h,key:u},f)=>l.addVideoChunkRaw(h,u?"key":"delta",c(f),c(f+1)-c(f),{decoderConfig:a})),l.finalize(),new Uint8Array(o.buffer)}var Pt={EBML:440786851,EBMLVersion:17030,EBMLReadVersion:17143,EBMLMaxIDLength:17138,EBMLMaxSizeLength:17139,DocType:17026,DocTypeVersion:17031,DocTypeReadVersion:17029,Segment:408125543,Info:357149030,TimestampScale:2807729,Duration:17545,MuxingApp:19840,WritingApp:22337,Tracks:374648427,TrackEntry:174,TrackNumber:215,TrackUID:29637,TrackType:131,FlagLacing:156,CodecID:134,DefaultDuration:2352003,Video:224,PixelWidth:176,PixelHeight:186,Cues:475249515,CuePoint:187,CueTime:179,CueTrackPositions:183,CueTrack:247,CueClusterPosition:241,Cluster:524531317,Timestamp:231,SimpleBlock:163},kP=3e4;function Hg(n){let e=new Uint8Array(n.reduce((i,s)=>i+s.length,0)),t=0;for(let i of n)e.set(i,t),t+=i.length;return e}function Vg(n,e=1){let t=[];for(let i=n;i>0||t.length<e;i=Math.floor(i/256))t.unshift(i%256);return Uint8Array.from(t)}function zi(n,...e){let t=Vg(e.reduce((i,s)=>i+s.length,0),8);return t[0]=1,Hg([Vg(n),t,...e])}function ti(n,e,t=1){return zi(n,Vg(e,t))}function _d(n,e){return zi(n,new TextEncoder().encode(e))}function BP(n,e){let t=new Uint8Array(8);return new DataView(t.buffer).setFloat64(0,e),zi(n,t)}function zP(n){let e=i=>Math.round(1e3*i/n.framesPerSecond),t=[];return n.frames.forEach((i,s)=>{let r=t.at(-1);(r===void 0||i.key||e(s)-e(r)>kP)&&t.push(s)}),t.map((i,s)=>{let r=e(i),a=n.frames.slice(i,t[s+1]).map((o,l)=>{let c=e(i+l)-r,h=Uint8Array.from([129,c>>8,c&255,o.key?128:0]);return zi(Pt.SimpleBlock,h,o.data)});return{start:r,bytes:zi(Pt.Cluster,ti(Pt.Timestamp,r),...a)}})}function x_(n){let{width:e,height:t,codec:i,framesPerSecond:s,frames:r}=n,a=zi(Pt.EBML,ti(Pt.EBMLVersion,1),ti(Pt.EBMLReadVersion,1),ti(Pt.EBMLMaxIDLength,4),ti(Pt.EBMLMaxSizeLength,8),_d(Pt.DocType,"webm"),ti(Pt.DocTypeVersion,4),ti(Pt.DocTypeReadVersion,2)),o=zi(Pt.Info,ti(Pt.TimestampScale,1e6),BP(Pt.Duration,1e3*r.length/s),_d(Pt.MuxingApp,"riprap"),_d(Pt.WritingApp,"riprap")),l=zi(Pt.TrackEntry,ti(Pt.TrackNumber,1),ti(Pt.TrackUID,1),ti(Pt.TrackType,1),ti(Pt.FlagLacing,0),_d(Pt.CodecID,i),ti(Pt.DefaultDuration,Math.round(1e9/s)),zi(Pt.Video,ti(Pt.PixelWidth,e),ti(Pt.PixelHeight,t))),c=Hg([o,zi(Pt.Tracks,l)]),h=zP(n),u=p=>zi(Pt.Cues,...h.map(({start:v},m)=>zi(Pt.CuePoint,ti(Pt.CueTime,v),zi(Pt.CueTrackPositions,ti(Pt.CueTrack,1),ti(Pt.CueClusterPosition,p[m],8))))),f=c.length+u(h.map(()=>0)).length,d=h.map(({bytes:p})=>(f+=p.length)-p.length);return Hg([a,zi(Pt.Segment,c,u(d),...h.map(p=>p.bytes))])}var __=2e3;function S_(n,e,t=document.createElement("canvas")){let i=n[0].stage.renderer.getPixelRatio(),s=getComputedStyle(document.documentElement),r=s.getPropertyValue("--ink").trim(),a=s.getPropertyValue("--paper").trim(),o=Math.round(26*i);for(let{stage:d}of n)d.stand(),d.draw();let l=n.map(d=>[d.stage.canvas.width,d.stage.canvas.height]),c=l.reduce((d,p)=>d+p[0],0)&-2,h=Math.max(...l.map(d=>d[1]))+o&-2;(t.width!==c||t.height!==h)&&(t.width=c,t.height=h);let u=t.getContext("2d");u.fillStyle=a,u.fillRect(0,0,c,h);let f=0;return n.forEach((d,p)=>{u.drawImage(d.stage.canvas,f,o);let{manifest:v}=d.run.summary,m=d.run.saidAt(d.frame);u.fillStyle=r,u.textBaseline="middle",u.font=`600 ${13*i}px system-ui, sans-serif`,u.fillText(`${v.title||d.run.summary.name}   ${m}`,f+12*i,o/2,l[p][0]-24*i),t_(u,ld(d,e),d.scale,[f+14*i,o+8*i,l[p][0]-28*i],i,r),Yx(u,d.labels(),[f,o,...l[p]],i,[r,a]),f+=l[p][0]}),t}function M_(n){return new Promise((e,t)=>{n.toBlob(i=>i?e(i):t(new Error("the browser made no picture")),"image/png")})}function Wg(n){return n.map(e=>e.run.summary.name.replace(/\.run$/,"")).join("_")}async function E_(n,e){let t=await M_(S_(n,e));Gr(t,`${Wg(n)}_${String(n[0].frame+1).padStart(6,"0")}.png`)}var HP=120;async function T_([n,e,t,i],s,r){t.pause();let a=t.at,o=n[0].stage.standpoint(),l=f=>n.forEach(d=>d.stage.follow(f)),c=document.createElement("canvas"),h=t.moments.length,u=i&&h===1?HP:h;try{for(let f=0;f<u;f++){if(!s(f/u))return!1;f<h&&await t.go(f),i&&l(i(f/Math.max(1,u-1))),await r(S_(n,e,c),f,u)}}finally{i&&l(o),await t.go(a)}return!0}async function A_(n,e){let t={};await T_(n,e,async(s,r,a)=>{if(a>__)throw new Error(`${a} frames are too many for one zip, which has at most ${__}: riprap shot RUN --all -o FILE.png writes them to a folder.`);let o=await M_(s);t[`frame_${String(r+1).padStart(6,"0")}.png`]=[new Uint8Array(await o.arrayBuffer()),{level:0}]})&&Gr(new Blob([lv(t)],{type:"application/zip"}),`${Wg(n[0])}_frames.zip`)}var Gg={webm:[{codec:"vp09.00.51.08",id:"V_VP9",name:"VP9"},{codec:"vp8",id:"V_VP8",name:"VP8"}],mp4:[{codec:"avc1.640034",id:"avc",name:"H.264"},{codec:"avc1.420034",id:"avc",name:"H.264"},{codec:"vp09.00.51.08",id:"vp9",name:"VP9"},{codec:"av01.0.12M.08",id:"av1",name:"AV1"}]},VP=50,GP=4;async function R_(){if(typeof VideoEncoder>"u")return null;for(let{codec:n,name:e}of Gg.mp4)if((await VideoEncoder.isConfigSupported({codec:n,width:1280,height:720}).catch(()=>null))?.supported)return e;return null}async function w_(n,e,t,i){if(typeof VideoEncoder>"u"){let a=window.isSecureContext?"This browser has no video encoder (WebCodecs).":"Browsers encode video only on pages of this machine (127.0.0.1) or served by https.";throw new Error(`${a} Save all frames as PNG instead, or write the film without a browser: riprap shot RUN --all -o film.apng`)}let s=Math.max(2e6,Math.round(.35*e*t*i));for(let a of Gg[n]){let o={codec:a.codec,width:e,height:t,framerate:i,bitrate:s,latencyMode:"quality"};if((await VideoEncoder.isConfigSupported(o)).supported)return[o,a]}let r=[...new Set(Gg[n].map(({name:a})=>a))].join(" or ");throw new Error(`This browser cannot encode ${r} at ${e} x ${t} pixels. Make the window smaller, or save all frames as PNG instead.`)}async function C_(n,e,t){let i=n[1].speed,s=[],r={},a=()=>{if(r.failed)throw new Error(`The browser could not encode the film: ${r.failed.message}`)},o=async({width:c,height:h})=>{let u={width:c,height:h,framesPerSecond:i,frames:s},f;if(t==="webm"){let[p,{id:v}]=await w_("webm",c,h,i);f=p,r.file=()=>x_({...u,codec:v})}else{let[p,{id:v}]=await w_("mp4",c,h,i);f=p,r.file=()=>b_({...u,codec:v,decoder:r.decoder??{codec:p.codec}})}r.size={width:c,height:h};let d=new VideoEncoder({output:(p,v)=>{v?.decoderConfig&&(r.decoder??=v.decoderConfig);let m=new Uint8Array(p.byteLength);p.copyTo(m),s.push({data:m,key:p.type==="key"})},error:p=>r.failed=p});return d.configure(f),r.encoder=d},l=0;try{let c=await T_(n,e,async(h,u,f)=>{l=f;let d=r.encoder??await o(h);if(h.width!==r.size.width||h.height!==r.size.height)throw new Error("The window changed its size while the film was made. Make it again and leave the window as it is.");let p=new VideoFrame(h,{timestamp:Math.round(1e6*u/i),duration:Math.round(1e6/i)});for(a(),d.encode(p,{keyFrame:u%VP===0}),p.close();d.encodeQueueSize>GP&&!r.failed;)await new Promise(v=>setTimeout(v,5))});if(a(),!c||!r.file)return;if(await r.encoder.flush(),a(),s.length!==l)throw new Error(`The browser encoded ${s.length} of ${l} frames. Save all frames as PNG instead.`);Gr(new Blob([r.file()],{type:`video/${t}`}),`${Wg(n[0])}.${t}`)}finally{r.encoder&&r.encoder.state!=="closed"&&r.encoder.close()}}function P_(n,e){let t=new Map(n.flatMap(i=>i.keys.map(s=>[s,i])));document.addEventListener("keydown",i=>{if(document.querySelector("dialog[open]"))return;let s=e.matches(":hover")||e.contains(document.activeElement);if(e.classList.contains("replay")&&!s||i.ctrlKey||i.metaKey||i.altKey)return;let r=i.target;if(r instanceof HTMLSelectElement||r instanceof HTMLInputElement&&["number","text"].includes(r.type)||r instanceof HTMLInputElement&&r.type==="range"&&i.key.startsWith("Arrow")||r instanceof HTMLButtonElement&&(i.key===" "||i.key==="Enter"))return;let l=t.get(i.key.length===1?i.key.toLowerCase():i.key);l&&(i.preventDefault(),l.act(i.shiftKey))})}function I_(n){let e=J("dialog.sheet",{"aria-label":"keyboard shortcuts"}),t=n.map(s=>J("tr",{},J("td",{},J("kbd",{},s.label)),J("td",{},s.what))),i=[["drag","rotate (in the plane: move)"],["right drag","move"],["wheel, pinch","zoom"],["click","pick a block; after d an end of the line"],["click in a plot","go to that time"]];return e.append(J("h2",{},"Keys and mouse"),J("div.columns",{},J("table",{},...t),J("table",{},...i.map(([s,r])=>J("tr",{},J("td",{},J("kbd",{},s)),J("td",{},r))))),J("button",{type:"button",onclick:()=>e.close()},"Close")),e.addEventListener("click",s=>{s.target===e&&e.close()}),e}var XP="uplot",$P="u-hz",qP="u-vt",YP="u-title",jP="u-wrap",ZP="u-under",JP="u-over",KP="u-axis",ka="u-off",QP="u-select",eI="u-cursor-x",tI="u-cursor-y",nI="u-cursor-pt",iI="u-legend",sI="u-live",rI="u-inline",aI="u-series",oI="u-marker",L_="u-label",lI="u-value",$c="width",qc="height";var D_="bottom",Ko="left",Xg="right",l0="#000",N_=l0+"0",$g="mousemove",U_="mousedown",qg="mouseup",F_="mouseenter",O_="mouseleave",k_="dblclick",cI="resize",hI="scroll",B_="change",Td="dppxchange",c0="--",rl=typeof window<"u",Kg=rl?document:null,el=rl?window:null,uI=rl?navigator:null,Ot,wd;function Qg(){let n=devicePixelRatio;Ot!=n&&(Ot=n,wd&&t0(B_,wd,Qg),wd=matchMedia(`(min-resolution: ${Ot-.001}dppx) and (max-resolution: ${Ot+.001}dppx)`),Ba(B_,wd,Qg),el.dispatchEvent(new CustomEvent(Td)))}function es(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function e0(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function hn(n,e,t){n.style[e]=t+"px"}function Rs(n,e,t,i){let s=Kg.createElement(n);return e!=null&&es(s,e),t?.insertBefore(s,i),s}function fs(n,e){return Rs("div",n,e)}var z_=new WeakMap;function nr(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",a=z_.get(n);r!=a&&(n.style.transform=r,z_.set(n,r),e<0||t<0||e>i||t>s?es(n,ka):e0(n,ka))}var H_=new WeakMap;function V_(n,e,t){let i=e+t,s=H_.get(n);i!=s&&(H_.set(n,i),n.style.background=e,n.style.borderColor=t)}var G_=new WeakMap;function W_(n,e,t,i){let s=e+""+t,r=G_.get(n);s!=r&&(G_.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var h0={passive:!0},fI={...h0,capture:!0};function Ba(n,e,t,i){e.addEventListener(n,t,i?fI:h0)}function t0(n,e,t,i){e.removeEventListener(n,t,h0)}rl&&Qg();function Cs(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:ts((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function y1(n){return(t,i,s)=>{let r=-1,a=-1;for(let o=i;o<=s;o++)if(n(t[o])){r=o;break}for(let o=s;o>=i;o--)if(n(t[o])){a=o;break}return[r,a]}}var b1=n=>n!=null,x1=n=>n!=null&&n>0,Cd=y1(b1),dI=y1(x1);function pI(n,e,t,i=0,s=!1){let r=s?dI:Cd,a=s?x1:b1;[e,t]=r(n,e,t);let o=n[e],l=n[e];if(e>-1)if(i==1)o=n[e],l=n[t];else if(i==-1)o=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];a(h)&&(h<o?o=h:h>l&&(l=h))}return[o??Jt,l??-Jt]}function Pd(n,e,t,i){let s=q_(n),r=q_(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let a=t==10?Ur:_1,o=s==1?ts:ds,l=r==1?ds:ts,c=o(a(Wn(n))),h=l(a(Wn(e))),u=tl(t,c),f=tl(t,h);return t==10&&(c<0&&(u=Kt(u,-c)),h<0&&(f=Kt(f,-h))),i||t==2?(n=u*s,e=f*r):(n=E1(n,u),e=Id(e,f)),[n,e]}function u0(n,e,t,i){let s=Pd(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var f0=.1,X_={mode:3,pad:f0},jc={pad:0,soft:null,mode:0},mI={min:jc,max:jc};function Ad(n,e,t,i){return Ld(t)?$_(n,e,t):(jc.pad=t,jc.soft=i?0:null,jc.mode=i?3:0,$_(n,e,mI))}function Lt(n,e){return n??e}function gI(n,e,t){for(e=Lt(e,0),t=Lt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function $_(n,e,t){let i=t.min,s=t.max,r=Lt(i.pad,0),a=Lt(s.pad,0),o=Lt(i.hard,-Jt),l=Lt(s.hard,Jt),c=Lt(i.soft,Jt),h=Lt(s.soft,-Jt),u=Lt(i.mode,0),f=Lt(s.mode,0),d=e-n,p=Ur(d),v=Li(Wn(n),Wn(e)),m=Ur(v),g=Wn(m-p);(d<1e-24||g>10)&&(d=0,(n==0||e==0)&&(d=1e-24,u==2&&c!=Jt&&(r=0),f==2&&h!=-Jt&&(a=0)));let y=d||v||1e3,_=Ur(y),x=tl(10,ts(_)),T=y*(d==0?n==0?.1:1:r),M=Kt(E1(n-T,x/10),24),b=n>=c&&(u==1||u==3&&M<=c||u==2&&M>=c)?c:Jt,S=Li(o,M<b&&n>=b?b:Ps(b,M)),C=y*(d==0?e==0?.1:1:a),I=Kt(Id(e+C,x/10),24),L=e<=h&&(f==1||f==3&&I>=h||f==2&&I<=h)?h:-Jt,O=Ps(l,I>L&&e<=L?L:Li(L,I));return S==O&&S==0&&(O=100),[S,O]}var vI=new Intl.NumberFormat(rl?uI.language:"en-US"),d0=n=>vI.format(n),ns=Math,Ed=ns.PI,Wn=ns.abs,ts=ns.floor,Gn=ns.round,ds=ns.ceil,Ps=ns.min,Li=ns.max,tl=ns.pow,q_=ns.sign,Ur=ns.log10,_1=ns.log2,yI=(n,e=1)=>ns.sinh(n)*e,Yg=(n,e=1)=>ns.asinh(n/e),Jt=1/0;function Y_(n){return(Ur((n^n>>31)-(n>>31))|0)+1}function n0(n,e,t){return Ps(Li(n,e),t)}function w1(n){return typeof n=="function"}function At(n){return w1(n)?n:()=>n}var bI=()=>{},S1=n=>n,M1=(n,e)=>e,xI=n=>null,j_=n=>!0,Z_=(n,e)=>n==e,_I=/\.\d*?(?=9{6,}|0{6,})/gm,za=n=>{if(A1(n)||aa.has(n))return n;let e=`${n}`,t=e.match(_I);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${za(s)}e${r}`}return Kt(n,i)};function Fa(n,e){return za(Kt(za(n/e))*e)}function Id(n,e){return za(ds(za(n/e))*e)}function E1(n,e){return za(ts(za(n/e))*e)}function Kt(n,e=0){if(A1(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Gn(i)/t}var aa=new Map;function T1(n){return((""+n).split(".")[1]||"").length}function Jc(n,e,t,i){let s=[],r=i.map(T1);for(let a=e;a<t;a++){let o=Wn(a),l=Kt(tl(n,a),o);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${a}`:i[c]*l,u=(a>=0?0:o)+(a>=r[c]?0:r[c]),f=n==10?h:Kt(h,u);s.push(f),aa.set(f,u)}}return s}var Zc={},p0=[],nl=[null,null],ra=Array.isArray,A1=Number.isInteger,wI=n=>n===void 0;function J_(n){return typeof n=="string"}function Ld(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function SI(n){return n!=null&&typeof n=="object"}var MI=Object.getPrototypeOf(Uint8Array),R1="__proto__";function il(n,e=Ld){let t;if(ra(n)){let i=n.find(s=>s!=null);if(ra(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=il(n[s],e)}else t=n.slice()}else if(n instanceof MI)t=n.slice();else if(e(n)){t={};for(let i in n)i!=R1&&(t[i]=il(n[i],e))}else t=n;return t}function Un(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=R1&&(Ld(n[s])?Un(n[s],il(i[s])):n[s]=il(i[s]))}return n}var EI=0,TI=1,AI=2;function RI(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let a=e[i];if(a>r){for(s=a-1;s>=0&&n[s]==null;)n[s--]=null;for(s=a+1;s<t&&n[s]==null;)n[r=s++]=null}}}function CI(n,e){if(LI(n)){let a=n[0].slice();for(let o=1;o<n.length;o++)a.push(...n[o].slice(1));return DI(a[0])||(a=II(a)),a}let t=new Set;for(let a=0;a<n.length;a++){let l=n[a][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((a,o)=>a-o)],s=i[0].length,r=new Map;for(let a=0;a<s;a++)r.set(i[0][a],a);for(let a=0;a<n.length;a++){let o=n[a],l=o[0];for(let c=1;c<o.length;c++){let h=o[c],u=Array(s).fill(void 0),f=e?e[a][c]:TI,d=[];for(let p=0;p<h.length;p++){let v=h[p],m=r.get(l[p]);v===null?f!=EI&&(u[m]=v,f==AI&&d.push(m)):u[m]=v}RI(u,d,s),i.push(u)}}return i}var PI=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function II(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,a)=>e[r]-e[a]);let s=[];for(let r=0;r<n.length;r++){let a=n[r],o=Array(t);for(let l=0;l<t;l++)o[l]=a[i[l]];s.push(o)}return s}function LI(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function DI(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Li(1,ts((s-i+1)/e));for(let a=n[i],o=i+r;o<=s;o+=r){let l=n[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}var C1=["January","February","March","April","May","June","July","August","September","October","November","December"],P1=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function I1(n){return n.slice(0,3)}var NI=P1.map(I1),UI=C1.map(I1),FI={MMMM:C1,MMM:UI,WWWW:P1,WWW:NI};function Xc(n){return(n<10?"0":"")+n}function OI(n){return(n<10?"00":n<100?"0":"")+n}var kI={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Xc(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Xc(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Xc(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Xc(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Xc(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>OI(n.getMilliseconds())};function m0(n,e){e=e||FI;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?kI[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<t.length;o++)a+=typeof t[o]=="string"?t[o]:t[o](r,e);return a}}var BI=new Intl.DateTimeFormat().resolvedOptions().timeZone;function zI(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==BI?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var L1=n=>n%1==0,Rd=[1,2,2.5,5],HI=Jc(10,-32,0,Rd),D1=Jc(10,0,32,Rd),VI=D1.filter(L1),Oa=HI.concat(D1),g0=`
`,N1="{YYYY}",K_=g0+N1,U1="{M}/{D}",Yc=g0+U1,Sd=Yc+"/{YY}",F1="{aa}",GI="{h}:{mm}",Qo=GI+F1,Q_=g0+Qo,e1=":{ss}",Ht=null;function O1(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,a=s*365,l=(n==1?Jc(10,0,3,Rd).filter(L1):Jc(10,-3,0,Rd)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]),c=[[a,N1,Ht,Ht,Ht,Ht,Ht,Ht,1],[s*28,"{MMM}",K_,Ht,Ht,Ht,Ht,Ht,1],[s,U1,K_,Ht,Ht,Ht,Ht,Ht,1],[i,"{h}"+F1,Sd,Ht,Yc,Ht,Ht,Ht,1],[t,Qo,Sd,Ht,Yc,Ht,Ht,Ht,1],[e,e1,Sd+" "+Qo,Ht,Yc+" "+Qo,Ht,Q_,Ht,1],[n,e1+".{fff}",Sd+" "+Qo,Ht,Yc+" "+Qo,Ht,Q_,Ht,1]];function h(u){return(f,d,p,v,m,g)=>{let y=[],_=m>=a,x=m>=r&&m<a,T=u(p),M=Kt(T*n,3),b=jg(T.getFullYear(),_?0:T.getMonth(),x||_?1:T.getDate()),S=Kt(b*n,3);if(x||_){let C=x?m/r:0,I=_?m/a:0,L=M==S?M:Kt(jg(b.getFullYear()+I,b.getMonth()+C,1)*n,3),O=new Date(Gn(L/n)),z=O.getFullYear(),U=O.getMonth();for(let G=0;L<=v;G++){let q=jg(z+I*G,U+C*G,1),H=q-u(Kt(q*n,3));L=Kt((+q+H)*n,3),L<=v&&y.push(L)}}else{let C=m>=s?s:m,I=ts(p)-ts(M),L=S+I+Id(M-S,C);y.push(L);let O=u(L),z=O.getHours()+O.getMinutes()/t+O.getSeconds()/i,U=m/i,G=f.axes[d]._space,q=g/G;for(;L=Kt(L+m,n==1?0:3),!(L>v);)if(U>1){let H=ts(Kt(z+U,6))%24,te=u(L).getHours()-H;te>1&&(te=-1),L-=te*i,z=(z+U)%24;let ne=y[y.length-1];Kt((L-ne)/m,3)*q>=.7&&y.push(L)}else y.push(L)}return y}}return[l,c,h]}var[WI,XI,$I]=O1(1),[qI,YI,jI]=O1(.001);Jc(2,-53,53,[1]);function t1(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function n1(n,e){return(t,i,s,r,a)=>{let o=e.find(p=>a>=p[0])||e[e.length-1],l,c,h,u,f,d;return i.map(p=>{let v=n(p),m=v.getFullYear(),g=v.getMonth(),y=v.getDate(),_=v.getHours(),x=v.getMinutes(),T=v.getSeconds(),M=m!=l&&o[2]||g!=c&&o[3]||y!=h&&o[4]||_!=u&&o[5]||x!=f&&o[6]||T!=d&&o[7]||o[1];return l=m,c=g,h=y,u=_,f=x,d=T,M(v)})}}function ZI(n,e){let t=m0(e);return(i,s,r,a,o)=>s.map(l=>t(n(l)))}function jg(n,e,t){return new Date(n,e,t)}function i1(n,e){return e(n)}var JI="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function s1(n,e){return(t,i,s,r)=>r==null?c0:e(n(i))}function KI(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function QI(n,e){return n.series[e].fill(n,e)}var eL={show:!0,live:!0,isolate:!1,mount:bI,markers:{show:!0,width:2,stroke:KI,fill:QI,dash:"solid"},idx:null,idxs:null,values:[]};function tL(n,e){let t=n.cursor.points,i=fs(),s=t.size(n,e);hn(i,$c,s),hn(i,qc,s);let r=s/-2;hn(i,"marginLeft",r),hn(i,"marginTop",r);let a=t.width(n,e,s);return a&&hn(i,"borderWidth",a),i}function nL(n,e){let t=n.series[e].points;return t._fill||t._stroke}function iL(n,e){let t=n.series[e].points;return t._stroke||t._fill}function sL(n,e){return n.series[e].points.size}var Zg=[0,0];function rL(n,e,t){return Zg[0]=e,Zg[1]=t,Zg}function Md(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Jg(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var aL={show:!0,x:!0,y:!0,lock:!1,move:rL,points:{one:!1,show:tL,size:sL,width:0,stroke:iL,fill:nL},bind:{mousedown:Md,mouseup:Md,click:Md,dblclick:Md,mousemove:Jg,mouseleave:Jg,mouseenter:Jg},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},k1={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},v0=Un({},k1,{filter:M1}),B1=Un({},v0,{size:10}),z1=Un({},k1,{show:!1}),y0='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',H1="bold "+y0,V1=1.5,r1={show:!0,scale:"x",stroke:l0,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:H1,side:2,grid:v0,ticks:B1,border:z1,font:y0,lineGap:V1,rotate:0},oL="Value",lL="Time",a1={show:!0,scale:"x",auto:!1,sorted:1,min:Jt,max:-Jt,idxs:[]};function cL(n,e,t,i,s){return e.map(r=>r==null?"":d0(r))}function hL(n,e,t,i,s,r,a){let o=[],l=aa.get(s)||0;t=a?t:Kt(Id(t,s),l);for(let c=t;c<=i;c=Kt(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function i0(n,e,t,i,s,r,a){let o=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ur:_1,h=ts(c(t));s=tl(l,h),l==10&&(s=Oa[Cs(s,Oa)]);let u=t,f=s*l;l==10&&(f=Oa[Cs(f,Oa)]);do o.push(u),u=u+s,l==10&&!aa.has(u)&&(u=Kt(u,aa.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=Oa[Cs(f,Oa)]));while(u<=i);return o}function uL(n,e,t,i,s,r,a){let l=n.scales[n.axes[e].scale].asinh,c=i>l?i0(n,e,Li(l,t),i,s):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?i0(n,e,Li(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(h,c)}var G1=/./,fL=/[12357]/,dL=/[125]/,o1=/1/,s0=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function pL(n,e,t,i,s){let r=n.axes[t],a=r.scale,o=n.scales[a],l=n.valToPos,c=r._space,h=l(10,a),u=l(9,a)-h>=c?G1:l(7,a)-h>=c?fL:l(5,a)-h>=c?dL:o1;if(u==o1){let f=Wn(l(1,a)-h);if(f<c)return s0(e.slice().reverse(),o.distr,u,ds(c/f)).reverse()}return s0(e,o.distr,u,1)}function mL(n,e,t,i,s){let r=n.axes[t],a=r.scale,o=r._space,l=n.valToPos,c=Wn(l(1,a)-l(2,a));return c<o?s0(e.slice().reverse(),3,G1,ds(o/c)).reverse():e}function gL(n,e,t,i){return i==null?c0:e==null?"":d0(e)}var l1={show:!0,scale:"y",stroke:l0,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:H1,side:3,grid:v0,ticks:B1,border:z1,font:y0,lineGap:V1,rotate:0};function vL(n,e){let t=3+(n||1)*2;return Kt(t*e,3)}function yL(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),a=n.valToPos(s[i[1]],t,!0),o=Wn(a-r),l=n.series[e],c=o/(l.points.space*Ot);return i[1]-i[0]<=c}var c1={scale:null,auto:!0,sorted:0,min:Jt,max:-Jt},W1=(n,e,t,i,s)=>s,h1={show:!0,auto:!0,sorted:0,gaps:W1,alpha:1,facets:[Un({},c1,{scale:"x"}),Un({},c1,{scale:"y"})]},u1={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:W1,alpha:1,points:{show:yL,filter:null},values:null,min:Jt,max:-Jt,idxs:[],path:null,clip:null};function bL(n,e,t,i,s){return t/10}var X1={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},xL=Un({},X1,{time:!1,ori:1}),f1={};function $1(n,e){let t=f1[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,a,o,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(i,s,r,a,o,l,c)}},n!=null&&(f1[n]=t)),t}var sl=1,r0=2;function Ha(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,a=n.scales,o=n.bbox,l=r[0],c=i==2?r[1]:r[e],h=i==2?a[s.facets[0].scale]:a[n.series[0].scale],u=i==2?a[s.facets[1].scale]:a[s.scale],f=o.left,d=o.top,p=o.width,v=o.height,m=n.valToPosH,g=n.valToPosV;return h.ori==0?t(s,l,c,h,u,m,g,f,d,p,v,Nd,al,Fd,Y1,Z1):t(s,l,c,h,u,g,m,d,f,v,p,Ud,ol,_0,j1,J1)}function b0(n,e){let t=0,i=0,s=Lt(n.bands,p0);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==e?t=a.dir:a.series[1]==e&&(a.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function _L(n,e,t,i,s){let r=n.mode,a=n.series[e],o=r==2?a.facets[1].scale:a.scale,l=n.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Fr(n,e,t,i,s,r){return Ha(n,e,(a,o,l,c,h,u,f,d,p,v,m)=>{let g=a.pxRound,y=c.dir*(c.ori==0?1:-1),_=c.ori==0?al:ol,x,T;y==1?(x=t,T=i):(x=i,T=t);let M=g(u(o[x],c,v,d)),b=g(f(l[x],h,m,p)),S=g(u(o[T],c,v,d)),C=g(f(r==1?h.max:h.min,h,m,p)),I=new Path2D(s);return _(I,S,C),_(I,M,C),_(I,M,b),I})}function Dd(n,e,t,i,s,r){let a=null;if(n.length>0){a=new Path2D;let o=e==0?Fd:_0,l=t;for(let u=0;u<n.length;u++){let f=n[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&o(a,l,i,d,i+r),l=f[1]}}let c=t+s-l,h=10;c>0&&o(a,l,i-h/2,c,i+r+h)}return a}function wL(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function x0(n,e,t,i,s,r,a){let o=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let u=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(n[u]),p=f==u?d:r(n[f]),v=u-s;d=a<=0&&v>=0&&v<l?r(n[v]):d;let g=f+s;p=a>=0&&g>=0&&g<l?r(n[g]):p,p>=d&&o.push([d,p])}return o}function d1(n){return n==0?S1:n==1?Gn:e=>Fa(e,n)}function q1(n){let e=n==0?Nd:Ud,t=n==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},i=n==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,h=0)=>{c==0&&h==0?i(s,r,a,o,l):(c=Ps(c,o/2,l/2),h=Ps(h,o/2,l/2),e(s,r+c,a),t(s,r+o,a,r+o,a+l,c),t(s,r+o,a+l,r,a+l,h),t(s,r,a+l,r,a,h),t(s,r,a,r+o,a,c),s.closePath())}}var Nd=(n,e,t)=>{n.moveTo(e,t)},Ud=(n,e,t)=>{n.moveTo(t,e)},al=(n,e,t)=>{n.lineTo(e,t)},ol=(n,e,t)=>{n.lineTo(t,e)},Fd=q1(0),_0=q1(1),Y1=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},j1=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Z1=(n,e,t,i,s,r,a)=>{n.bezierCurveTo(e,t,i,s,r,a)},J1=(n,e,t,i,s,r,a)=>{n.bezierCurveTo(t,e,s,i,a,r)};function K1(n){return(e,t,i,s,r)=>Ha(e,t,(a,o,l,c,h,u,f,d,p,v,m)=>{let{pxRound:g,points:y}=a,_,x;c.ori==0?(_=Nd,x=Y1):(_=Ud,x=j1);let T=Kt(y.width*Ot,3),M=(y.size-y.width)/2*Ot,b=Kt(M*2,3),S=new Path2D,C=new Path2D,{left:I,top:L,width:O,height:z}=e.bbox;Fd(C,I-b,L-b,O+b*2,z+b*2);let U=G=>{if(l[G]!=null){let q=g(u(o[G],c,v,d)),H=g(f(l[G],h,m,p));_(S,q+M,H),x(S,q,H,M,0,Ed*2)}};if(r)r.forEach(U);else for(let G=i;G<=s;G++)U(G);return{stroke:T>0?S:null,fill:S,clip:C,flags:sl|r0}})}function Q1(n){return(e,t,i,s,r,a)=>{i!=s&&(r!=i&&a!=i&&n(e,t,i),r!=s&&a!=s&&n(e,t,s),n(e,t,a))}}var SL=Q1(al),ML=Q1(ol);function ew(n){let e=Lt(n?.alignGaps,0);return(t,i,s,r)=>Ha(t,i,(a,o,l,c,h,u,f,d,p,v,m)=>{[s,r]=Cd(l,s,r);let g=a.pxRound,y=z=>g(u(z,c,v,d)),_=z=>g(f(z,h,m,p)),x,T;c.ori==0?(x=al,T=SL):(x=ol,T=ML);let M=c.dir*(c.ori==0?1:-1),b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:sl},S=b.stroke,C=!1;if(r-s>=v*4){let z=he=>t.posToVal(he,c.key,!0),U=null,G=null,q,H,le,j=y(o[M==1?s:r]),te=y(o[s]),ne=y(o[r]),pe=z(M==1?te+1:ne-1);for(let he=M==1?s:r;he>=s&&he<=r;he+=M){let Q=o[he],ve=(M==1?Q<pe:Q>pe)?j:y(Q),Ee=l[he];ve==j?Ee!=null?(H=Ee,U==null?(x(S,ve,_(H)),q=U=G=H):H<U?U=H:H>G&&(G=H)):Ee===null&&(C=!0):(U!=null&&T(S,j,_(U),_(G),_(q),_(H)),Ee!=null?(H=Ee,x(S,ve,_(H)),U=G=q=H):(U=G=null,Ee===null&&(C=!0)),j=ve,pe=z(j+M))}U!=null&&U!=G&&le!=j&&T(S,j,_(U),_(G),_(q),_(H))}else for(let z=M==1?s:r;z>=s&&z<=r;z+=M){let U=l[z];U===null?C=!0:U!=null&&x(S,y(o[z]),_(U))}let[L,O]=b0(t,i);if(a.fill!=null||L!=0){let z=b.fill=new Path2D(S),U=a.fillTo(t,i,a.min,a.max,L),G=_(U),q=y(o[s]),H=y(o[r]);M==-1&&([H,q]=[q,H]),x(z,H,G),x(z,q,G)}if(!a.spanGaps){let z=[];C&&z.push(...x0(o,l,s,r,M,y,e)),b.gaps=z=a.gaps(t,i,s,r,z),b.clip=Dd(z,c.ori,d,p,v,m)}return O!=0&&(b.band=O==2?[Fr(t,i,s,r,S,-1),Fr(t,i,s,r,S,1)]:Fr(t,i,s,r,S,O)),b})}function EL(n){let e=Lt(n.align,1),t=Lt(n.ascDesc,!1),i=Lt(n.alignGaps,0),s=Lt(n.extend,!1);return(r,a,o,l)=>Ha(r,a,(c,h,u,f,d,p,v,m,g,y,_)=>{[o,l]=Cd(u,o,l);let x=c.pxRound,{left:T,width:M}=r.bbox,b=te=>x(p(te,f,y,m)),S=te=>x(v(te,d,_,g)),C=f.ori==0?al:ol,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:sl},L=I.stroke,O=f.dir*(f.ori==0?1:-1),z=S(u[O==1?o:l]),U=b(h[O==1?o:l]),G=U,q=U;s&&e==-1&&(q=T,C(L,q,z)),C(L,U,z);for(let te=O==1?o:l;te>=o&&te<=l;te+=O){let ne=u[te];if(ne==null)continue;let pe=b(h[te]),he=S(ne);e==1?C(L,pe,z):C(L,G,he),C(L,pe,he),z=he,G=pe}let H=G;s&&e==1&&(H=T+M,C(L,H,z));let[le,j]=b0(r,a);if(c.fill!=null||le!=0){let te=I.fill=new Path2D(L),ne=c.fillTo(r,a,c.min,c.max,le),pe=S(ne);C(te,H,pe),C(te,q,pe)}if(!c.spanGaps){let te=[];te.push(...x0(h,u,o,l,O,b,i));let ne=c.width*Ot/2,pe=t||e==1?ne:-ne,he=t||e==-1?-ne:ne;te.forEach(Q=>{Q[0]+=pe,Q[1]+=he}),I.gaps=te=c.gaps(r,a,o,l,te),I.clip=Dd(te,f.ori,m,g,y,_)}return j!=0&&(I.band=j==2?[Fr(r,a,o,l,L,-1),Fr(r,a,o,l,L,1)]:Fr(r,a,o,l,L,j)),I})}function p1(n,e,t,i,s,r,a=Jt){if(n.length>1){let o=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(o!=null){let h=Wn(n[l]-n[o]);h<c&&(c=h,a=Wn(t(n[l],i,s,r)-t(n[o],i,s,r)))}o=l}}return a}function TL(n){n=n||Zc;let e=Lt(n.size,[.6,Jt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=At(s),a=1-e[0],o=Lt(e[1],Jt),l=Lt(e[2],1),c=Lt(n.disp,Zc),h=Lt(n.each,d=>{}),{fill:u,stroke:f}=c;return(d,p,v,m)=>Ha(d,p,(g,y,_,x,T,M,b,S,C,I,L)=>{let O=g.pxRound,z=t,U=i*Ot,G=o*Ot,q=l*Ot,H,le;x.ori==0?[H,le]=r(d,p):[le,H]=r(d,p);let j=x.dir*(x.ori==0?1:-1),te=x.ori==0?Fd:_0,ne=x.ori==0?h:(Ie,Ke,ft,Te,Yt,We,Ze)=>{h(Ie,Ke,ft,Yt,Te,Ze,We)},pe=Lt(d.bands,p0).find(Ie=>Ie.series[0]==p),he=pe!=null?pe.dir:0,Q=g.fillTo(d,p,g.min,g.max,he),fe=O(b(Q,T,L,C)),ve,Ee,be,Xe=I,ot=O(g.width*Ot),Ge=!1,dt=null,ut=null,Qe=null,un=null;u!=null&&(ot==0||f!=null)&&(Ge=!0,dt=u.values(d,p,v,m),ut=new Map,new Set(dt).forEach(Ie=>{Ie!=null&&ut.set(Ie,new Path2D)}),ot>0&&(Qe=f.values(d,p,v,m),un=new Map,new Set(Qe).forEach(Ie=>{Ie!=null&&un.set(Ie,new Path2D)})));let{x0:Qt,size:Tn}=c;if(Qt!=null&&Tn!=null){z=1,y=Qt.values(d,p,v,m),Qt.unit==2&&(y=y.map(ft=>d.posToVal(S+ft*I,x.key,!0)));let Ie=Tn.values(d,p,v,m);Tn.unit==2?Ee=Ie[0]*I:Ee=M(Ie[0],x,I,S)-M(0,x,I,S),Xe=p1(y,_,M,x,I,S,Xe),be=Xe-Ee+U}else Xe=p1(y,_,M,x,I,S,Xe),be=Xe*a+U,Ee=Xe-be;be<1&&(be=0),ot>=Ee/2&&(ot=0),be<5&&(O=S1);let Xt=be>0,Xn=Xe-be-(Xt?ot:0);Ee=O(n0(Xn,q,G)),ve=(z==0?Ee/2:z==j?0:Ee)-z*j*((z==0?U/2:0)+(Xt?ot/2:0));let Rt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Fn=Ge?null:new Path2D,yn=null;if(pe!=null)yn=d.data[pe.series[1]];else{let{y0:Ie,y1:Ke}=c;Ie!=null&&Ke!=null&&(_=Ke.values(d,p,v,m),yn=Ie.values(d,p,v,m))}let An=H*Ee,B=le*Ee;for(let Ie=j==1?v:m;Ie>=v&&Ie<=m;Ie+=j){let Ke=_[Ie];if(Ke==null)continue;if(yn!=null){let $=yn[Ie]??0;if(Ke-$==0)continue;fe=b($,T,L,C)}let ft=x.distr!=2||c!=null?y[Ie]:Ie,Te=M(ft,x,I,S),Yt=b(Lt(Ke,Q),T,L,C),We=O(Te-ve),Ze=O(Li(Yt,fe)),D=O(Ps(Yt,fe)),E=Ze-D;if(Ke!=null){let $=Ke<0?B:An,de=Ke<0?An:B;Ge?(ot>0&&Qe[Ie]!=null&&te(un.get(Qe[Ie]),We,D+ts(ot/2),Ee,Li(0,E-ot),$,de),dt[Ie]!=null&&te(ut.get(dt[Ie]),We,D+ts(ot/2),Ee,Li(0,E-ot),$,de)):te(Fn,We,D+ts(ot/2),Ee,Li(0,E-ot),$,de),ne(d,p,Ie,We-ot/2,D,Ee+ot,E)}}return ot>0?Rt.stroke=Ge?un:Fn:Ge||(Rt._fill=g.width==0?g._fill:g._stroke??g._fill,Rt.width=0),Rt.fill=Ge?ut:Fn,Rt})}function AL(n,e){let t=Lt(e?.alignGaps,0);return(i,s,r,a)=>Ha(i,s,(o,l,c,h,u,f,d,p,v,m,g)=>{[r,a]=Cd(c,r,a);let y=o.pxRound,_=H=>y(f(H,h,m,p)),x=H=>y(d(H,u,g,v)),T,M,b;h.ori==0?(T=Nd,b=al,M=Z1):(T=Ud,b=ol,M=J1);let S=h.dir*(h.ori==0?1:-1),C=_(l[S==1?r:a]),I=C,L=[],O=[];for(let H=S==1?r:a;H>=r&&H<=a;H+=S)if(c[H]!=null){let j=l[H],te=_(j);L.push(I=te),O.push(x(c[H]))}let z={stroke:n(L,O,T,b,M,y),fill:null,clip:null,band:null,gaps:null,flags:sl},U=z.stroke,[G,q]=b0(i,s);if(o.fill!=null||G!=0){let H=z.fill=new Path2D(U),le=o.fillTo(i,s,o.min,o.max,G),j=x(le);b(H,I,j),b(H,C,j)}if(!o.spanGaps){let H=[];H.push(...x0(l,c,r,a,S,_,t)),z.gaps=H=o.gaps(i,s,r,a,H),z.clip=Dd(H,h.ori,p,v,m,g)}return q!=0&&(z.band=q==2?[Fr(i,s,r,a,U,-1),Fr(i,s,r,a,U,1)]:Fr(i,s,r,a,U,q)),z})}function RL(n){return AL(CL,n)}function CL(n,e,t,i,s,r){let a=n.length;if(a<2)return null;let o=new Path2D;if(t(o,n[0],e[0]),a==2)i(o,n[1],e[1]);else{let l=Array(a),c=Array(a-1),h=Array(a-1),u=Array(a-1);for(let f=0;f<a-1;f++)h[f]=e[f+1]-e[f],u[f]=n[f+1]-n[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<a-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[a-1]=c[a-2];for(let f=0;f<a-1;f++)s(o,n[f]+u[f]/3,e[f]+l[f]*u[f]/3,n[f+1]-u[f]/3,e[f+1]-l[f+1]*u[f]/3,n[f+1],e[f+1])}return o}var a0=new Set;function m1(){for(let n of a0)n.syncRect(!0)}rl&&(Ba(cI,el,m1),Ba(hI,el,m1,!0),Ba(Td,el,()=>{ni.pxRatio=Ot}));var PL=ew(),IL=K1();function g1(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,a)=>o0(r,a,e,t))}function LL(n,e){return n.map((t,i)=>i==0?{}:Un({},e,t))}function o0(n,e,t,i){return Un({},e==0?t:i,n)}function tw(n,e,t){return e==null?nl:[e,t]}var DL=tw;function NL(n,e,t){return e==null?nl:Ad(e,t,f0,!0)}function nw(n,e,t,i){return e==null?nl:Pd(e,t,n.scales[i].log,!1)}var UL=nw;function iw(n,e,t,i){return e==null?nl:u0(e,t,n.scales[i].log,!1)}var FL=iw;function OL(n,e,t,i,s){let r=Li(Y_(n),Y_(e)),a=e-n,o=Cs(s/i*a,t);do{let l=t[o],c=i*l/a;if(c>=s&&r+(l<5?aa.get(l):0)<=17)return[l,c]}while(++o<t.length);return[0,0]}function v1(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Gn((t=+s)*Ot))+"px"),[n,e,t]}function kL(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Kt(e[2]*Ot,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function ni(n,e,t){let i={mode:Lt(n.mode,1)},s=i.mode;function r(w,A,N,F){let X=A.valToPct(w);return F+N*(A.dir==-1?1-X:X)}function a(w,A,N,F){let X=A.valToPct(w);return F+N*(A.dir==-1?X:1-X)}function o(w,A,N,F){return A.ori==0?r(w,A,N,F):a(w,A,N,F)}i.valToPosH=r,i.valToPosV=a;let l=!1;i.status=0;let c=i.root=fs(XP);if(n.id!=null&&(c.id=n.id),es(c,n.class),n.title){let w=fs(YP,c);w.textContent=n.title}let h=Rs("canvas"),u=i.ctx=h.getContext("2d"),f=fs(jP,c);Ba("click",f,w=>{w.target===p&&(sn!=Ya||fn!=ja)&&ii.click(i,w)},!0);let d=i.under=fs(ZP,f);f.appendChild(h);let p=i.over=fs(JP,f);n=il(n);let v=+Lt(n.pxAlign,1),m=d1(v);(n.plugins||[]).forEach(w=>{w.opts&&(n=w.opts(i,n)||n)});let g=n.ms||.001,y=i.series=s==1?g1(n.series||[],a1,u1,!1):LL(n.series||[null],h1),_=i.axes=g1(n.axes||[],r1,l1,!0),x=i.scales={},T=i.bands=n.bands||[];T.forEach(w=>{w.fill=At(w.fill||null),w.dir=Lt(w.dir,-1)});let M=s==2?y[1].facets[0].scale:y[0].scale,b={axes:ar,series:_t},S=(n.drawOrder||["axes","series"]).map(w=>b[w]);function C(w){let A=w.distr==3?N=>Ur(N>0?N:w.clamp(i,N,w.min,w.max,w.key)):w.distr==4?N=>Yg(N,w.asinh):w.distr==100?N=>w.fwd(N):N=>N;return N=>{let F=A(N),{_min:X,_max:K}=w,ce=K-X;return(F-X)/ce}}function I(w){let A=x[w];if(A==null){let N=(n.scales||Zc)[w]||Zc;if(N.from!=null){I(N.from);let F=Un({},x[N.from],N,{key:w});F.valToPct=C(F),x[w]=F}else{A=x[w]=Un({},w==M?X1:xL,N),A.key=w;let F=A.time,X=A.range,K=ra(X);if((w!=M||s==2&&!F)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?X_:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?X_:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&Ld(X))){let ce=X;X=(me,we,Ue)=>we==null?nl:Ad(we,Ue,ce)}A.range=At(X||(F?DL:w==M?A.distr==3?UL:A.distr==4?FL:tw:A.distr==3?nw:A.distr==4?iw:NL)),A.auto=At(K?!1:A.auto),A.clamp=At(A.clamp||bL),A._min=A._max=null,A.valToPct=C(A)}}}I("x"),I("y"),s==1&&y.forEach(w=>{I(w.scale)}),_.forEach(w=>{I(w.scale)});for(let w in n.scales)I(w);let L=x[M],O=L.distr,z,U;L.ori==0?(es(c,$P),z=r,U=a):(es(c,qP),z=a,U=r);let G={};for(let w in x){let A=x[w];(A.min!=null||A.max!=null)&&(G[w]={min:A.min,max:A.max},A.min=A.max=null)}let q=n.tzDate||(w=>new Date(Gn(w/g))),H=n.fmtDate||m0,le=g==1?$I(q):jI(q),j=n1(q,t1(g==1?XI:YI,H)),te=s1(q,i1(JI,H)),ne=[],pe=i.legend=Un({},eL,n.legend),he=i.cursor=Un({},aL,{drag:{y:s==2}},n.cursor),Q=pe.show,fe=he.show,ve=pe.markers;pe.idxs=ne,ve.width=At(ve.width),ve.dash=At(ve.dash),ve.stroke=At(ve.stroke),ve.fill=At(ve.fill);let Ee,be,Xe,ot=[],Ge=[],dt,ut=!1,Qe={};if(pe.live){let w=y[1]?y[1].values:null;ut=w!=null,dt=ut?w(i,1,0):{_:0};for(let A in dt)Qe[A]=c0}if(Q)if(Ee=Rs("table",iI,c),Xe=Rs("tbody",null,Ee),pe.mount(i,Ee),ut){be=Rs("thead",null,Ee,Xe);let w=Rs("tr",null,be);Rs("th",null,w);for(var un in dt)Rs("th",L_,w).textContent=un}else es(Ee,rI),pe.live&&es(Ee,sI);let Qt={show:!0},Tn={show:!1};function Xt(w,A){if(A==0&&(ut||!pe.live||s==2))return nl;let N=[],F=Rs("tr",aI,Xe,Xe.childNodes[A]);es(F,w.class),w.show||es(F,ka);let X=Rs("th",null,F);if(ve.show){let me=fs(oI,X);if(A>0){let we=ve.width(i,A);we&&(me.style.border=we+"px "+ve.dash(i,A)+" "+ve.stroke(i,A)),me.style.background=ve.fill(i,A)}}let K=fs(L_,X);w.label instanceof HTMLElement?K.appendChild(w.label):K.textContent=w.label,A>0&&(ve.show||(K.style.color=w.width>0?ve.stroke(i,A):ve.fill(i,A)),Rt("click",X,me=>{if(he._lock)return;it(me);let we=y.indexOf(w);if((me.ctrlKey||me.metaKey)!=pe.isolate){let Ue=y.some((Fe,Be)=>Be>0&&Be!=we&&Fe.show);y.forEach((Fe,Be)=>{Be>0&&Ns(Be,Ue?Be==we?Qt:Tn:Qt,!0,In.setSeries)})}else Ns(we,{show:!w.show},!0,In.setSeries)},!1),st&&Rt(F_,X,me=>{he._lock||(it(me),Ns(y.indexOf(w),Ja,!0,In.setSeries))},!1));for(var ce in dt){let me=Rs("td",lI,F);me.textContent="--",N.push(me)}return[F,N]}let Xn=new Map;function Rt(w,A,N,F=!0){let X=Xn.get(A)||{},K=he.bind[w](i,A,N,F);K&&(Ba(w,A,X[w]=K),Xn.set(A,X))}function Fn(w,A,N){let F=Xn.get(A)||{};for(let X in F)(w==null||X==w)&&(t0(X,A,F[X]),delete F[X]);w==null&&Xn.delete(A)}let yn=0,An=0,B=0,Ie=0,Ke=0,ft=0,Te=Ke,Yt=ft,We=B,Ze=Ie,D=0,E=0,$=0,de=0;i.bbox={};let oe=!1,xe=!1,_e=!1,ie=!1,re=!1,ge=!1;function k(w,A,N){(N||w!=i.width||A!=i.height)&&ae(w,A),gt(!1),_e=!0,xe=!0,fi()}function ae(w,A){i.width=yn=B=w,i.height=An=Ie=A,Ke=ft=0,Me(),$e();let N=i.bbox;D=N.left=Fa(Ke*Ot,.5),E=N.top=Fa(ft*Ot,.5),$=N.width=Fa(B*Ot,.5),de=N.height=Fa(Ie*Ot,.5)}let se=3;function Ae(){let w=!1,A=0;for(;!w;){A++;let N=Xa(A),F=Ds(A);w=A==se||N&&F,w||(ae(i.width,i.height),xe=!0)}}function ye({width:w,height:A}){k(w,A)}i.setSize=ye;function Me(){let w=!1,A=!1,N=!1,F=!1;_.forEach((X,K)=>{if(X.show&&X._show){let{side:ce,_size:me}=X,we=ce%2,Ue=X.label!=null?X.labelSize:0,Fe=me+Ue;Fe>0&&(we?(B-=Fe,ce==3?(Ke+=Fe,F=!0):N=!0):(Ie-=Fe,ce==0?(ft+=Fe,w=!0):A=!0))}}),Is[0]=w,Is[1]=N,Is[2]=A,Is[3]=F,B-=ps[1]+ps[3],Ke+=ps[3],Ie-=ps[2]+ps[0],ft+=ps[0]}function $e(){let w=Ke+B,A=ft+Ie,N=Ke,F=ft;function X(K,ce){switch(K){case 1:return w+=ce,w-ce;case 2:return A+=ce,A-ce;case 3:return N-=ce,N+ce;case 0:return F-=ce,F+ce}}_.forEach((K,ce)=>{if(K.show&&K._show){let me=K.side;K._pos=X(me,K._size),K.label!=null&&(K._lpos=X(me,K.labelSize))}})}if(he.dataIdx==null){let w=he.hover,A=w.skip=new Set(w.skip??[]);A.add(void 0);let N=w.prox=At(w.prox),F=w.bias??=0;he.dataIdx=(X,K,ce,me)=>{if(K==0)return ce;let we=ce,Ue=N(X,K,ce,me)??Jt,Fe=Ue>=0&&Ue<Jt,Be=L.ori==0?B:Ie,ht=he.left,Dt=e[0],It=e[K];if(A.has(It[ce])){we=null;let wt=null,et=null,Ye;if(F==0||F==-1)for(Ye=ce;wt==null&&Ye-- >0;)A.has(It[Ye])||(wt=Ye);if(F==0||F==1)for(Ye=ce;et==null&&Ye++<It.length;)A.has(It[Ye])||(et=Ye);if(wt!=null||et!=null)if(Fe){let an=wt==null?-1/0:z(Dt[wt],L,Be,0),_n=et==null?1/0:z(Dt[et],L,Be,0),jn=ht-an,$t=_n-ht;jn<=$t?jn<=Ue&&(we=wt):$t<=Ue&&(we=et)}else we=et==null?wt:wt==null?et:ce-wt<=et-ce?wt:et}else Fe&&Wn(ht-z(Dt[ce],L,Be,0))>Ue&&(we=null);return we}}let it=w=>{he.event=w};he.idxs=ne,he._lock=!1;let ue=he.points;ue.show=At(ue.show),ue.size=At(ue.size),ue.stroke=At(ue.stroke),ue.width=At(ue.width),ue.fill=At(ue.fill);let ze=i.focus=Un({},n.focus||{alpha:.3},he.focus),st=ze.prox>=0,Pe=st&&ue.one,pt=[],nn=[],xi=[];function cl(w,A){let N=ue.show(i,A);if(N instanceof HTMLElement)return es(N,nI),es(N,w.class),nr(N,-10,-10,B,Ie),p.insertBefore(N,pt[A]),N}function Va(w,A){if(s==1||A>0){let N=s==1&&x[w.scale].time,F=w.value;w.value=N?J_(F)?s1(q,i1(F,H)):F||te:F||gL,w.label=w.label||(N?lL:oL)}if(Pe||A>0){w.width=w.width==null?1:w.width,w.paths=w.paths||PL||xI,w.fillTo=At(w.fillTo||_L),w.pxAlign=+Lt(w.pxAlign,v),w.pxRound=d1(w.pxAlign),w.stroke=At(w.stroke||null),w.fill=At(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let N=vL(Li(1,w.width),1),F=w.points=Un({},{size:N,width:Li(1,N*.2),stroke:w.stroke,space:N*2,paths:IL,_stroke:null,_fill:null},w.points);F.show=At(F.show),F.filter=At(F.filter),F.fill=At(F.fill),F.stroke=At(F.stroke),F.paths=At(F.paths),F.pxAlign=w.pxAlign}if(Q){let N=Xt(w,A);ot.splice(A,0,N[0]),Ge.splice(A,0,N[1]),pe.values.push(null)}if(fe){ne.splice(A,0,null);let N=null;Pe?A==0&&(N=cl(w,A)):A>0&&(N=cl(w,A)),pt.splice(A,0,N),nn.splice(A,0,0),xi.splice(A,0,0)}Yn("addSeries",A)}function qd(w,A){A=A??y.length,w=s==1?o0(w,A,a1,u1):o0(w,A,{},h1),y.splice(A,0,w),Va(y[A],A)}i.addSeries=qd;function Qc(w){if(y.splice(w,1),Q){pe.values.splice(w,1),Ge.splice(w,1);let A=ot.splice(w,1)[0];Fn(null,A.firstChild),A.remove()}fe&&(ne.splice(w,1),pt.splice(w,1)[0].remove(),nn.splice(w,1),xi.splice(w,1)),Yn("delSeries",w)}i.delSeries=Qc;let Is=[!1,!1,!1,!1];function ir(w,A){if(w._show=w.show,w.show){let N=w.side%2,F=x[w.scale];F==null&&(w.scale=N?y[1].scale:M,F=x[w.scale]);let X=F.time;w.size=At(w.size),w.space=At(w.space),w.rotate=At(w.rotate),ra(w.incrs)&&w.incrs.forEach(ce=>{!aa.has(ce)&&aa.set(ce,T1(ce))}),w.incrs=At(w.incrs||(F.distr==2?VI:X?g==1?WI:qI:Oa)),w.splits=At(w.splits||(X&&F.distr==1?le:F.distr==3?i0:F.distr==4?uL:hL)),w.stroke=At(w.stroke),w.grid.stroke=At(w.grid.stroke),w.ticks.stroke=At(w.ticks.stroke),w.border.stroke=At(w.border.stroke);let K=w.values;w.values=ra(K)&&!ra(K[0])?At(K):X?ra(K)?n1(q,t1(K,H)):J_(K)?ZI(q,K):K||j:K||cL,w.filter=At(w.filter||(F.distr>=3&&F.log==10?pL:F.distr==3&&F.log==2?mL:M1)),w.font=v1(w.font),w.labelFont=v1(w.labelFont),w._size=w.size(i,null,A,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(Is[A]=!0,w._el=fs(KP,f))}}function sr(w,A,N,F){let[X,K,ce,me]=N,we=A%2,Ue=0;return we==0&&(me||K)&&(Ue=A==0&&!X||A==2&&!ce?Gn(r1.size/3):0),we==1&&(X||ce)&&(Ue=A==1&&!K||A==3&&!me?Gn(l1.size/2):0),Ue}let hl=i.padding=(n.padding||[sr,sr,sr,sr]).map(w=>At(Lt(w,sr))),ps=i._padding=hl.map((w,A)=>w(i,A,Is,0)),bn,Sn=null,Mn=null,Ls=s==1?y[0].idxs:null,Hi=null,Or=!1;function ul(w,A){if(e=w??[],i.data=i._data=e,s==2){bn=0;for(let N=1;N<y.length;N++)bn+=e[N][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),Hi=e[0],bn=Hi.length;let N=e;if(O==2){N=e.slice();let F=N[0]=Array(bn);for(let X=0;X<bn;X++)F[X]=X}i._data=e=N}if(gt(!0),Yn("setData"),O==2&&(_e=!0),A!==!1){let N=L;N.auto(i,Or)?fl():zr(M,N.min,N.max),ie=ie||he.left>=0,ge=!0,fi()}}i.setData=ul;function fl(){Or=!0;let w,A;s==1&&(bn>0?(Sn=Ls[0]=0,Mn=Ls[1]=bn-1,w=e[0][Sn],A=e[0][Mn],O==2?(w=Sn,A=Mn):w==A&&(O==3?[w,A]=Pd(w,w,L.log,!1):O==4?[w,A]=u0(w,w,L.log,!1):L.time?A=w+Gn(86400/g):[w,A]=Ad(w,A,f0,!0))):(Sn=Ls[0]=w=null,Mn=Ls[1]=A=null)),zr(M,w,A)}let Ga,kr,Wa,R,V,ee,Y,Z,Re,De;function Ce(w,A,N,F,X,K){w??=N_,N??=p0,F??="butt",X??=N_,K??="round",w!=Ga&&(u.strokeStyle=Ga=w),X!=kr&&(u.fillStyle=kr=X),A!=Wa&&(u.lineWidth=Wa=A),K!=V&&(u.lineJoin=V=K),F!=ee&&(u.lineCap=ee=F),N!=R&&u.setLineDash(R=N)}function Ne(w,A,N,F){A!=kr&&(u.fillStyle=kr=A),w!=Y&&(u.font=Y=w),N!=Z&&(u.textAlign=Z=N),F!=Re&&(u.textBaseline=Re=F)}function Ve(w,A,N,F,X=0){if(F.length>0&&w.auto(i,Or)&&(A==null||A.min==null)){let K=Lt(Sn,0),ce=Lt(Mn,F.length-1),me=N.min==null?pI(F,K,ce,X,w.distr==3):[N.min,N.max];w.min=Ps(w.min,N.min=me[0]),w.max=Li(w.max,N.max=me[1])}}let lt={min:null,max:null};function xt(){for(let F in x){let X=x[F];G[F]==null&&(X.min==null||G[M]!=null&&X.auto(i,Or))&&(G[F]=lt)}for(let F in x){let X=x[F];G[F]==null&&X.from!=null&&G[X.from]!=null&&(G[F]=lt)}G[M]!=null&&gt(!0);let w={};for(let F in G){let X=G[F];if(X!=null){let K=w[F]=il(x[F],SI);if(X.min!=null)Un(K,X);else if(F!=M||s==2)if(bn==0&&K.from==null){let ce=K.range(i,null,null,F);K.min=ce[0],K.max=ce[1]}else K.min=Jt,K.max=-Jt}}if(bn>0){y.forEach((F,X)=>{if(s==1){let K=F.scale,ce=G[K];if(ce==null)return;let me=w[K];if(X==0){let we=me.range(i,me.min,me.max,K);me.min=we[0],me.max=we[1],Sn=Cs(me.min,e[0]),Mn=Cs(me.max,e[0]),Mn-Sn>1&&(e[0][Sn]<me.min&&Sn++,e[0][Mn]>me.max&&Mn--),F.min=Hi[Sn],F.max=Hi[Mn]}else F.show&&F.auto&&Ve(me,ce,F,e[X],F.sorted);F.idxs[0]=Sn,F.idxs[1]=Mn}else if(X>0&&F.show&&F.auto){let[K,ce]=F.facets,me=K.scale,we=ce.scale,[Ue,Fe]=e[X],Be=w[me],ht=w[we];Be!=null&&Ve(Be,G[me],K,Ue,K.sorted),ht!=null&&Ve(ht,G[we],ce,Fe,ce.sorted),F.min=ce.min,F.max=ce.max}});for(let F in w){let X=w[F],K=G[F];if(X.from==null&&(K==null||K.min==null)){let ce=X.range(i,X.min==Jt?null:X.min,X.max==-Jt?null:X.max,F);X.min=ce[0],X.max=ce[1]}}}for(let F in w){let X=w[F];if(X.from!=null){let K=w[X.from];if(K.min==null)X.min=X.max=null;else{let ce=X.range(i,K.min,K.max,F);X.min=ce[0],X.max=ce[1]}}}let A={},N=!1;for(let F in w){let X=w[F],K=x[F];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let ce=K.distr;K._min=ce==3?Ur(K.min):ce==4?Yg(K.min,K.asinh):ce==100?K.fwd(K.min):K.min,K._max=ce==3?Ur(K.max):ce==4?Yg(K.max,K.asinh):ce==100?K.fwd(K.max):K.max,A[F]=N=!0}}if(N){y.forEach((F,X)=>{s==2?X>0&&A.y&&(F._paths=null):A[F.scale]&&(F._paths=null)});for(let F in A)_e=!0,Yn("setScale",F);fe&&he.left>=0&&(ie=ge=!0)}for(let F in G)G[F]=null}function He(w){let A=n0(Sn-1,0,bn-1),N=n0(Mn+1,0,bn-1);for(;w[A]==null&&A>0;)A--;for(;w[N]==null&&N<bn-1;)N++;return[A,N]}function _t(){if(bn>0){let w=y.some(A=>A._focus)&&De!=ze.alpha;w&&(u.globalAlpha=De=ze.alpha),y.forEach((A,N)=>{if(N>0&&A.show&&(mn(N,!1),mn(N,!0),A._paths==null)){let F=De;De!=A.alpha&&(u.globalAlpha=De=A.alpha);let X=s==2?[0,e[N][0].length-1]:He(e[N]);A._paths=A.paths(i,N,X[0],X[1]),De!=F&&(u.globalAlpha=De=F)}}),y.forEach((A,N)=>{if(N>0&&A.show){let F=De;De!=A.alpha&&(u.globalAlpha=De=A.alpha),A._paths!=null&&Vt(N,!1);{let X=A._paths!=null?A._paths.gaps:null,K=A.points.show(i,N,Sn,Mn,X),ce=A.points.filter(i,N,K,X);(K||ce)&&(A.points._paths=A.points.paths(i,N,Sn,Mn,ce),Vt(N,!0))}De!=F&&(u.globalAlpha=De=F),Yn("drawSeries",N)}}),w&&(u.globalAlpha=De=1)}}function mn(w,A){let N=A?y[w].points:y[w];N._stroke=N.stroke(i,w),N._fill=N.fill(i,w)}function Vt(w,A){let N=A?y[w].points:y[w],{stroke:F,fill:X,clip:K,flags:ce,_stroke:me=N._stroke,_fill:we=N._fill,_width:Ue=N.width}=N._paths;Ue=Kt(Ue*Ot,3);let Fe=null,Be=Ue%2/2;A&&we==null&&(we=Ue>0?"#fff":me);let ht=N.pxAlign==1&&Be>0;if(ht&&u.translate(Be,Be),!A){let Dt=D-Ue/2,It=E-Ue/2,wt=$+Ue,et=de+Ue;Fe=new Path2D,Fe.rect(Dt,It,wt,et)}A?Oe(me,Ue,N.dash,N.cap,we,F,X,ce,K):Gt(w,me,Ue,N.dash,N.cap,we,F,X,ce,Fe,K),ht&&u.translate(-Be,-Be)}function Gt(w,A,N,F,X,K,ce,me,we,Ue,Fe){let Be=!1;we!=0&&T.forEach((ht,Dt)=>{if(ht.series[0]==w){let It=y[ht.series[1]],wt=e[ht.series[1]],et=(It._paths||Zc).band;ra(et)&&(et=ht.dir==1?et[0]:et[1]);let Ye,an=null;It.show&&et&&gI(wt,Sn,Mn)?(an=ht.fill(i,Dt)||K,Ye=It._paths.clip):et=null,Oe(A,N,F,X,an,ce,me,we,Ue,Fe,Ye,et),Be=!0}}),Be||Oe(A,N,F,X,K,ce,me,we,Ue,Fe)}let On=sl|r0;function Oe(w,A,N,F,X,K,ce,me,we,Ue,Fe,Be){Ce(w,A,N,F,X),(we||Ue||Be)&&(u.save(),we&&u.clip(we),Ue&&u.clip(Ue)),Be?(me&On)==On?(u.clip(Be),Fe&&u.clip(Fe),Mt(X,ce),Rn(w,K,A)):me&r0?(Mt(X,ce),u.clip(Be),Rn(w,K,A)):me&sl&&(u.save(),u.clip(Be),Fe&&u.clip(Fe),Mt(X,ce),u.restore(),Rn(w,K,A)):(Mt(X,ce),Rn(w,K,A)),(we||Ue||Be)&&u.restore()}function Rn(w,A,N){N>0&&(A instanceof Map?A.forEach((F,X)=>{u.strokeStyle=Ga=X,u.stroke(F)}):A!=null&&w&&u.stroke(A))}function Mt(w,A){A instanceof Map?A.forEach((N,F)=>{u.fillStyle=kr=F,u.fill(N)}):A!=null&&w&&u.fill(A)}function rr(w,A,N,F){let X=_[w],K;if(F<=0)K=[0,0];else{let ce=X._space=X.space(i,w,A,N,F),me=X._incrs=X.incrs(i,w,A,N,F,ce);K=OL(A,N,me,F,ce)}return X._found=K}function Cn(w,A,N,F,X,K,ce,me,we,Ue){let Fe=ce%2/2;v==1&&u.translate(Fe,Fe),Ce(me,ce,we,Ue,me),u.beginPath();let Be,ht,Dt,It,wt=X+(F==0||F==3?-K:K);N==0?(ht=X,It=wt):(Be=X,Dt=wt);for(let et=0;et<w.length;et++)A[et]!=null&&(N==0?Be=Dt=w[et]:ht=It=w[et],u.moveTo(Be,ht),u.lineTo(Dt,It));u.stroke(),v==1&&u.translate(-Fe,-Fe)}function Xa(w){let A=!0;return _.forEach((N,F)=>{if(!N.show)return;let X=x[N.scale];if(X.min==null){N._show&&(A=!1,N._show=!1,gt(!1));return}else N._show||(A=!1,N._show=!0,gt(!1));let K=N.side,ce=K%2,{min:me,max:we}=X,[Ue,Fe]=rr(F,me,we,ce==0?B:Ie);if(Fe==0)return;let Be=X.distr==2,ht=N._splits=N.splits(i,F,me,we,Ue,Fe,Be),Dt=X.distr==2?ht.map(Ye=>Hi[Ye]):ht,It=X.distr==2?Hi[ht[1]]-Hi[ht[0]]:Ue,wt=N._values=N.values(i,N.filter(i,Dt,F,Fe,It),F,Fe,It);N._rotate=K==2?N.rotate(i,wt,F,Fe):0;let et=N._size;N._size=ds(N.size(i,wt,F,w)),et!=null&&N._size!=et&&(A=!1)}),A}function Ds(w){let A=!0;return hl.forEach((N,F)=>{let X=N(i,F,Is,w);X!=ps[F]&&(A=!1),ps[F]=X}),A}function ar(){for(let w=0;w<_.length;w++){let A=_[w];if(!A.show||!A._show)continue;let N=A.side,F=N%2,X,K,ce=A.stroke(i,w),me=N==0||N==3?-1:1,[we,Ue]=A._found;if(A.label!=null){let Si=A.labelGap*me,Wi=Gn((A._lpos+Si)*Ot);Ne(A.labelFont[0],ce,"center",N==2?"top":D_),u.save(),F==1?(X=K=0,u.translate(Wi,Gn(E+de/2)),u.rotate((N==3?-Ed:Ed)/2)):(X=Gn(D+$/2),K=Wi);let ha=w1(A.label)?A.label(i,w,we,Ue):A.label;u.fillText(ha,X,K),u.restore()}if(Ue==0)continue;let Fe=x[A.scale],Be=F==0?$:de,ht=F==0?D:E,Dt=A._splits,It=Fe.distr==2?Dt.map(Si=>Hi[Si]):Dt,wt=Fe.distr==2?Hi[Dt[1]]-Hi[Dt[0]]:we,et=A.ticks,Ye=A.border,an=et.show?et.size:0,_n=Gn(an*Ot),jn=Gn((A.alignTo==2?A._size-an-A.gap:A.gap)*Ot),$t=A._rotate*-Ed/180,wn=m(A._pos*Ot),Vi=(_n+jn)*me,wi=wn+Vi;K=F==0?wi:0,X=F==1?wi:0;let is=A.font[0],ms=A.align==1?Ko:A.align==2?Xg:$t>0?Ko:$t<0?Xg:F==0?"center":N==3?Xg:Ko,Fs=$t||F==1?"middle":N==2?"top":D_;Ne(is,ce,ms,Fs);let Gi=A.font[1]*A.lineGap,ss=Dt.map(Si=>m(o(Si,Fe,Be,ht))),gs=A._values;for(let Si=0;Si<gs.length;Si++){let Wi=gs[Si];if(Wi!=null){F==0?X=ss[Si]:K=ss[Si],Wi=""+Wi;let ha=Wi.indexOf(`
`)==-1?[Wi]:Wi.split(/\n/gm);for(let Mi=0;Mi<ha.length;Mi++){let X0=ha[Mi];$t?(u.save(),u.translate(X,K+Mi*Gi),u.rotate($t),u.fillText(X0,0,0),u.restore()):u.fillText(X0,X,K+Mi*Gi)}}}et.show&&Cn(ss,et.filter(i,It,w,Ue,wt),F,N,wn,_n,Kt(et.width*Ot,3),et.stroke(i,w),et.dash,et.cap);let Os=A.grid;Os.show&&Cn(ss,Os.filter(i,It,w,Ue,wt),F,F==0?2:1,F==0?E:D,F==0?de:$,Kt(Os.width*Ot,3),Os.stroke(i,w),Os.dash,Os.cap),Ye.show&&Cn([wn],[1],F==0?1:0,F==0?1:2,F==1?E:D,F==1?de:$,Kt(Ye.width*Ot,3),Ye.stroke(i,w),Ye.dash,Ye.cap)}Yn("drawAxes")}function gt(w){y.forEach((A,N)=>{N>0&&(A._paths=null,w&&(s==1?(A.min=null,A.max=null):A.facets.forEach(F=>{F.min=null,F.max=null})))})}let xn=!1,_i=!1,Wt=[];function Pn(){_i=!1;for(let w=0;w<Wt.length;w++)Yn(...Wt[w]);Wt.length=0}function fi(){xn||(PI(A0),xn=!0)}function eh(w,A=!1){xn=!0,_i=A,w(i),A0(),A&&Wt.length>0&&queueMicrotask(Pn)}i.batch=eh;function A0(){if(oe&&(xt(),oe=!1),_e&&(Ae(),_e=!1),xe){if(hn(d,Ko,Ke),hn(d,"top",ft),hn(d,$c,B),hn(d,qc,Ie),hn(p,Ko,Ke),hn(p,"top",ft),hn(p,$c,B),hn(p,qc,Ie),hn(f,$c,yn),hn(f,qc,An),h.width=Gn(yn*Ot),h.height=Gn(An*Ot),_.forEach(({_el:w,_show:A,_size:N,_pos:F,side:X})=>{if(w!=null)if(A){let K=X===3||X===0?N:0,ce=X%2==1;hn(w,ce?"left":"top",F-K),hn(w,ce?"width":"height",N),hn(w,ce?"top":"left",ce?ft:Ke),hn(w,ce?"height":"width",ce?Ie:B),e0(w,ka)}else es(w,ka)}),Ga=kr=Wa=V=ee=Y=Z=Re=R=null,De=1,ml(!0),Ke!=Te||ft!=Yt||B!=We||Ie!=Ze){gt(!1);let w=B/We,A=Ie/Ze;if(fe&&!ie&&he.left>=0){he.left*=w,he.top*=A,$a&&nr($a,Gn(he.left),0,B,Ie),qa&&nr(qa,0,Gn(he.top),B,Ie);for(let N=0;N<pt.length;N++){let F=pt[N];F!=null&&(nn[N]*=w,xi[N]*=A,nr(F,ds(nn[N]),ds(xi[N]),B,Ie))}}if(rn.show&&!re&&rn.left>=0&&rn.width>0){rn.left*=w,rn.width*=w,rn.top*=A,rn.height*=A;for(let N in Qd)hn(Za,N,rn[N])}Te=Ke,Yt=ft,We=B,Ze=Ie}Yn("setSize"),xe=!1}yn>0&&An>0&&(u.clearRect(0,0,h.width,h.height),Yn("drawClear"),S.forEach(w=>w()),Yn("draw")),rn.show&&re&&(th(rn),re=!1),fe&&ie&&(ca(null,!0,!1),ie=!1),pe.show&&pe.live&&ge&&(Jd(),ge=!1),l||(l=!0,i.status=1,Yn("ready")),Or=!1,xn=!1}i.redraw=(w,A)=>{_e=A||!1,w!==!1?zr(M,L.min,L.max):fi()};function Yd(w,A){let N=x[w];if(N.from==null){if(bn==0){let F=N.range(i,A.min,A.max,w);A.min=F[0],A.max=F[1]}if(A.min>A.max){let F=A.min;A.min=A.max,A.max=F}if(bn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;w==M&&N.distr==2&&bn>0&&(A.min=Cs(A.min,e[0]),A.max=Cs(A.max,e[0]),A.min==A.max&&A.max++),G[w]=A,oe=!0,fi()}}i.setScale=Yd;let jd,Zd,$a,qa,R0,C0,Ya,ja,P0,I0,sn,fn,Br=!1,ii=he.drag,$n=ii.x,qn=ii.y;fe&&(he.x&&(jd=fs(eI,p)),he.y&&(Zd=fs(tI,p)),L.ori==0?($a=jd,qa=Zd):($a=Zd,qa=jd),sn=he.left,fn=he.top);let rn=i.select=Un({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Za=rn.show?fs(QP,rn.over?p:d):null;function th(w,A){if(rn.show){for(let N in w)rn[N]=w[N],N in Qd&&hn(Za,N,w[N]);A!==!1&&Yn("setSelect")}}i.setSelect=th;function dw(w){if(y[w].show)Q&&e0(ot[w],ka);else if(Q&&es(ot[w],ka),fe){let N=Pe?pt[0]:pt[w];N!=null&&nr(N,-10,-10,B,Ie)}}function zr(w,A,N){Yd(w,{min:A,max:N})}function Ns(w,A,N,F){A.focus!=null&&yw(w),A.show!=null&&y.forEach((X,K)=>{K>0&&(w==K||w==null)&&(X.show=A.show,dw(K),s==2?(zr(X.facets[0].scale,null,null),zr(X.facets[1].scale,null,null)):zr(X.scale,null,null),fi())}),N!==!1&&Yn("setSeries",w,A),F&&gl("setSeries",i,w,A)}i.setSeries=Ns;function pw(w,A){Un(T[w],A)}function mw(w,A){w.fill=At(w.fill||null),w.dir=Lt(w.dir,-1),A=A??T.length,T.splice(A,0,w)}function gw(w){w==null?T.length=0:T.splice(w,1)}i.addBand=mw,i.setBand=pw,i.delBand=gw;function vw(w,A){y[w].alpha=A,fe&&pt[w]!=null&&(pt[w].style.opacity=A),Q&&ot[w]&&(ot[w].style.opacity=A)}let or,Hr,la,Ja={focus:!0};function yw(w){if(w!=la){let A=w==null,N=ze.alpha!=1;y.forEach((F,X)=>{if(s==1||X>0){let K=A||X==0||X==w;F._focus=A?null:K,N&&vw(X,K?1:ze.alpha)}}),la=w,N&&fi()}}Q&&st&&Rt(O_,Ee,w=>{he._lock||(it(w),la!=null&&Ns(null,Ja,!0,In.setSeries))});function Us(w,A,N){let F=x[A];N&&(w=w/Ot-(F.ori==1?ft:Ke));let X=B;F.ori==1&&(X=Ie,w=X-w),F.dir==-1&&(w=X-w);let K=F._min,ce=F._max,me=w/X,we=K+(ce-K)*me,Ue=F.distr;return Ue==3?tl(10,we):Ue==4?yI(we,F.asinh):Ue==100?F.bwd(we):we}function bw(w,A){let N=Us(w,M,A);return Cs(N,e[0],Sn,Mn)}i.valToIdx=w=>Cs(w,e[0]),i.posToIdx=bw,i.posToVal=Us,i.valToPos=(w,A,N)=>x[A].ori==0?r(w,x[A],N?$:B,N?D:0):a(w,x[A],N?de:Ie,N?E:0),i.setCursor=(w,A,N)=>{sn=w.left,fn=w.top,ca(null,A,N)};function L0(w,A){hn(Za,Ko,rn.left=w),hn(Za,$c,rn.width=A)}function D0(w,A){hn(Za,"top",rn.top=w),hn(Za,qc,rn.height=A)}let dl=L.ori==0?L0:D0,pl=L.ori==1?L0:D0;function xw(){if(Q&&pe.live)for(let w=s==2?1:0;w<y.length;w++){if(w==0&&ut)continue;let A=pe.values[w],N=0;for(let F in A)Ge[w][N++].firstChild.nodeValue=A[F]}}function Jd(w,A){if(w!=null&&(w.idxs?w.idxs.forEach((N,F)=>{ne[F]=N}):wI(w.idx)||ne.fill(w.idx),pe.idx=ne[0]),Q&&pe.live){for(let N=0;N<y.length;N++)(N>0||s==1&&!ut)&&_w(N,ne[N]);xw()}ge=!1,A!==!1&&Yn("setLegend")}i.setLegend=Jd;function _w(w,A){let N=y[w],F=w==0&&O==2?Hi:e[w],X;ut?X=N.values(i,w,A)??Qe:(X=N.value(i,A==null?null:F[A],w,A),X=X==null?Qe:{_:X}),pe.values[w]=X}function ca(w,A,N){P0=sn,I0=fn,[sn,fn]=he.move(i,sn,fn),he.left=sn,he.top=fn,fe&&($a&&nr($a,Gn(sn),0,B,Ie),qa&&nr(qa,0,Gn(fn),B,Ie));let F,X=Sn>Mn;or=Jt,Hr=null;let K=L.ori==0?B:Ie,ce=L.ori==1?B:Ie;if(sn<0||bn==0||X){F=he.idx=null;for(let me=0;me<y.length;me++){let we=pt[me];we!=null&&nr(we,-10,-10,B,Ie)}st&&Ns(null,Ja,!0,w==null&&In.setSeries),pe.live&&(ne.fill(F),ge=!0)}else{let me,we,Ue;s==1&&(me=L.ori==0?sn:fn,we=Us(me,M),F=he.idx=Cs(we,e[0],Sn,Mn),Ue=z(e[0][F],L,K,0));let Fe=-10,Be=-10,ht=0,Dt=0,It=!0,wt="",et="";for(let Ye=s==2?1:0;Ye<y.length;Ye++){let an=y[Ye],_n=ne[Ye],jn=_n==null?null:s==1?e[Ye][_n]:e[Ye][1][_n],$t=he.dataIdx(i,Ye,F,we),wn=$t==null?null:s==1?e[Ye][$t]:e[Ye][1][$t];if(ge=ge||wn!=jn||$t!=_n,ne[Ye]=$t,Ye>0&&an.show){let Vi=$t==null?-10:$t==F?Ue:z(s==1?e[0][$t]:e[Ye][0][$t],L,K,0),wi=wn==null?-10:U(wn,s==1?x[an.scale]:x[an.facets[1].scale],ce,0);if(st&&wn!=null){let is=L.ori==1?sn:fn,ms=Wn(ze.dist(i,Ye,$t,wi,is));if(ms<or){let Fs=ze.bias;if(Fs!=0){let Gi=Us(is,an.scale),ss=wn>=0?1:-1,gs=Gi>=0?1:-1;gs==ss&&(gs==1?Fs==1?wn>=Gi:wn<=Gi:Fs==1?wn<=Gi:wn>=Gi)&&(or=ms,Hr=Ye)}else or=ms,Hr=Ye}}if(ge||Pe){let is,ms;L.ori==0?(is=Vi,ms=wi):(is=wi,ms=Vi);let Fs,Gi,ss,gs,Os,Si,Wi=!0,ha=ue.bbox;if(ha!=null){Wi=!1;let Mi=ha(i,Ye);ss=Mi.left,gs=Mi.top,Fs=Mi.width,Gi=Mi.height}else ss=is,gs=ms,Fs=Gi=ue.size(i,Ye);if(Si=ue.fill(i,Ye),Os=ue.stroke(i,Ye),Pe)Ye==Hr&&or<=ze.prox&&(Fe=ss,Be=gs,ht=Fs,Dt=Gi,It=Wi,wt=Si,et=Os);else{let Mi=pt[Ye];Mi!=null&&(nn[Ye]=ss,xi[Ye]=gs,W_(Mi,Fs,Gi,Wi),V_(Mi,Si,Os),nr(Mi,ds(ss),ds(gs),B,Ie))}}}}if(Pe){let Ye=ze.prox,an=la==null?or<=Ye:or>Ye||Hr!=la;if(ge||an){let _n=pt[0];_n!=null&&(nn[0]=Fe,xi[0]=Be,W_(_n,ht,Dt,It),V_(_n,wt,et),nr(_n,ds(Fe),ds(Be),B,Ie))}}}if(rn.show&&Br)if(w!=null){let[me,we]=In.scales,[Ue,Fe]=In.match,[Be,ht]=w.cursor.sync.scales,Dt=w.cursor.drag;if($n=Dt._x,qn=Dt._y,$n||qn){let{left:It,top:wt,width:et,height:Ye}=w.select,an=w.scales[Be].ori,_n=w.posToVal,jn,$t,wn,Vi,wi,is=me!=null&&Ue(me,Be),ms=we!=null&&Fe(we,ht);is&&$n?(an==0?(jn=It,$t=et):(jn=wt,$t=Ye),wn=x[me],Vi=z(_n(jn,Be),wn,K,0),wi=z(_n(jn+$t,Be),wn,K,0),dl(Ps(Vi,wi),Wn(wi-Vi))):dl(0,K),ms&&qn?(an==1?(jn=It,$t=et):(jn=wt,$t=Ye),wn=x[we],Vi=U(_n(jn,ht),wn,ce,0),wi=U(_n(jn+$t,ht),wn,ce,0),pl(Ps(Vi,wi),Wn(wi-Vi))):pl(0,ce)}else ep()}else{let me=Wn(P0-R0),we=Wn(I0-C0);if(L.ori==1){let ht=me;me=we,we=ht}$n=ii.x&&me>=ii.dist,qn=ii.y&&we>=ii.dist;let Ue=ii.uni;Ue!=null?$n&&qn&&($n=me>=Ue,qn=we>=Ue,!$n&&!qn&&(we>me?qn=!0:$n=!0)):ii.x&&ii.y&&($n||qn)&&($n=qn=!0);let Fe,Be;$n&&(L.ori==0?(Fe=Ya,Be=sn):(Fe=ja,Be=fn),dl(Ps(Fe,Be),Wn(Be-Fe)),qn||pl(0,ce)),qn&&(L.ori==1?(Fe=Ya,Be=sn):(Fe=ja,Be=fn),pl(Ps(Fe,Be),Wn(Be-Fe)),$n||dl(0,K)),!$n&&!qn&&(dl(0,0),pl(0,0))}if(ii._x=$n,ii._y=qn,w==null){if(N){if(W0!=null){let[me,we]=In.scales;In.values[0]=me!=null?Us(L.ori==0?sn:fn,me):null,In.values[1]=we!=null?Us(L.ori==1?sn:fn,we):null}gl($g,i,sn,fn,B,Ie,F)}if(st){let me=N&&In.setSeries,we=ze.prox;la==null?or<=we&&Ns(Hr,Ja,!0,me):or>we?Ns(null,Ja,!0,me):Hr!=la&&Ns(Hr,Ja,!0,me)}}ge&&(pe.idx=F,Jd()),A!==!1&&Yn("setCursor")}let Vr=null;Object.defineProperty(i,"rect",{get(){return Vr==null&&ml(!1),Vr}});function ml(w=!1){w?Vr=null:(Vr=p.getBoundingClientRect(),Yn("syncRect",Vr))}function N0(w,A,N,F,X,K,ce){he._lock||Br&&w!=null&&w.movementX==0&&w.movementY==0||(Kd(w,A,N,F,X,K,ce,!1,w!=null),w!=null?ca(null,!0,!0):ca(A,!0,!1))}function Kd(w,A,N,F,X,K,ce,me,we){if(Vr==null&&ml(!1),it(w),w!=null)N=w.clientX-Vr.left,F=w.clientY-Vr.top;else{if(N<0||F<0){sn=-10,fn=-10;return}let[Ue,Fe]=In.scales,Be=A.cursor.sync,[ht,Dt]=Be.values,[It,wt]=Be.scales,[et,Ye]=In.match,an=A.axes[0].side%2==1,_n=L.ori==0?B:Ie,jn=L.ori==1?B:Ie,$t=an?K:X,wn=an?X:K,Vi=an?F:N,wi=an?N:F;if(It!=null?N=et(Ue,It)?o(ht,x[Ue],_n,0):-10:N=_n*(Vi/$t),wt!=null?F=Ye(Fe,wt)?o(Dt,x[Fe],jn,0):-10:F=jn*(wi/wn),L.ori==1){let is=N;N=F,F=is}}we&&(A==null||A.cursor.event.type==$g)&&((N<=1||N>=B-1)&&(N=Fa(N,B)),(F<=1||F>=Ie-1)&&(F=Fa(F,Ie))),me?(R0=N,C0=F,[Ya,ja]=he.move(i,N,F)):(sn=N,fn=F)}let Qd={width:0,height:0,left:0,top:0};function ep(){th(Qd,!1)}let U0,F0,O0,k0;function B0(w,A,N,F,X,K,ce){Br=!0,$n=qn=ii._x=ii._y=!1,Kd(w,A,N,F,X,K,ce,!0,!1),w!=null&&(Rt(qg,Kg,z0,!1),gl(U_,i,Ya,ja,B,Ie,null));let{left:me,top:we,width:Ue,height:Fe}=rn;U0=me,F0=we,O0=Ue,k0=Fe}function z0(w,A,N,F,X,K,ce){Br=ii._x=ii._y=!1,Kd(w,A,N,F,X,K,ce,!1,!0);let{left:me,top:we,width:Ue,height:Fe}=rn,Be=Ue>0||Fe>0,ht=U0!=me||F0!=we||O0!=Ue||k0!=Fe;if(Be&&ht&&th(rn),ii.setScale&&Be&&ht){let Dt=me,It=Ue,wt=we,et=Fe;if(L.ori==1&&(Dt=we,It=Fe,wt=me,et=Ue),$n&&zr(M,Us(Dt,M),Us(Dt+It,M)),qn)for(let Ye in x){let an=x[Ye];Ye!=M&&an.from==null&&an.min!=Jt&&zr(Ye,Us(wt+et,Ye),Us(wt,Ye))}ep()}else he.lock&&(he._lock=!he._lock,ca(A,!0,w!=null));w!=null&&(Fn(qg,Kg),gl(qg,i,sn,fn,B,Ie,null))}function ww(w,A,N,F,X,K,ce){if(he._lock)return;it(w);let me=Br;if(Br){let we=!0,Ue=!0,Fe=10,Be,ht;L.ori==0?(Be=$n,ht=qn):(Be=qn,ht=$n),Be&&ht&&(we=sn<=Fe||sn>=B-Fe,Ue=fn<=Fe||fn>=Ie-Fe),Be&&we&&(sn=sn<Ya?0:B),ht&&Ue&&(fn=fn<ja?0:Ie),ca(null,!0,!0),Br=!1}sn=-10,fn=-10,ne.fill(null),ca(null,!0,!0),me&&(Br=me)}function H0(w,A,N,F,X,K,ce){he._lock||(it(w),fl(),ep(),w!=null&&gl(k_,i,sn,fn,B,Ie,null))}function V0(){_.forEach(kL),k(i.width,i.height,!0)}Ba(Td,el,V0);let Ka={};Ka.mousedown=B0,Ka.mousemove=N0,Ka.mouseup=z0,Ka.dblclick=H0,Ka.setSeries=(w,A,N,F)=>{let X=In.match[2];N=X(i,A,N),N!=-1&&Ns(N,F,!0,!1)},fe&&(Rt(U_,p,B0),Rt($g,p,N0),Rt(F_,p,w=>{it(w),ml(!1)}),Rt(O_,p,ww),Rt(k_,p,H0),a0.add(i),i.syncRect=ml);let nh=i.hooks=n.hooks||{};function Yn(w,A,N){_i?Wt.push([w,A,N]):w in nh&&nh[w].forEach(F=>{F.call(null,i,A,N)})}(n.plugins||[]).forEach(w=>{for(let A in w.hooks)nh[A]=(nh[A]||[]).concat(w.hooks[A])});let G0=(w,A,N)=>N,In=Un({key:null,setSeries:!1,filters:{pub:j_,sub:j_},scales:[M,y[1]?y[1].scale:null],match:[Z_,Z_,G0],values:[null,null]},he.sync);In.match.length==2&&In.match.push(G0),he.sync=In;let W0=In.key,tp=$1(W0);function gl(w,A,N,F,X,K,ce){In.filters.pub(w,A,N,F,X,K,ce)&&tp.pub(w,A,N,F,X,K,ce)}tp.sub(i);function Sw(w,A,N,F,X,K,ce){In.filters.sub(w,A,N,F,X,K,ce)&&Ka[w](null,A,N,F,X,K,ce)}i.pub=Sw;function Mw(){tp.unsub(i),a0.delete(i),Xn.clear(),t0(Td,el,V0),c.remove(),Ee?.remove(),Yn("destroy")}i.destroy=Mw;function np(){Yn("init",n,e),ul(e||n.data,!1),G[M]?Yd(M,G[M]):fl(),re=rn.show&&(rn.width>0||rn.height>0),ie=ge=!0,k(n.width,n.height)}return y.forEach(Va),_.forEach(ir),t?t instanceof HTMLElement?(t.appendChild(c),np()):t(i,np):np(),i}ni.assign=Un;ni.fmtNum=d0;ni.rangeNum=Ad;ni.rangeLog=Pd;ni.rangeAsinh=u0;ni.orient=Ha;ni.pxRatio=Ot;ni.join=CI;ni.fmtDate=m0,ni.tzDate=zI;ni.sync=$1;{ni.addGap=wL,ni.clipGaps=Dd;let n=ni.paths={points:K1};n.linear=ew,n.stepped=EL,n.bars=TL,n.spline=RL}var Od=["#2f7ed8","#e4572e","#2a9d5c","#9a5fc9","#d99a1c","#17a2b0","#c2448d","#7a7f87"],kd=class{constructor(e,t,i){this.runs=e;this.seek=t;this.lines=i;this.object=J("section.plots",{"aria-label":"histories"},J("div.plothead",{},this.bar,this.extra),this.body),new ResizeObserver(()=>this.resize()).observe(this.body),this.tabs()}runs;seek;lines;object;tab="histories";now=null;body=J("div.charts");bar=J("div.tabs",{role:"tablist"});extra=J("span.extra");plots=[];curves=[];blockField="displacement";picked=null;stamp=0;tabs(){let e=[["histories","Histories"],["energy","Energy"],["block","Block"],["line","Line"]];this.bar.replaceChildren(...e.map(([t,i])=>J("button",{role:"tab",type:"button","aria-selected":String(t===this.tab),onclick:()=>{this.open(t)}},i)))}async open(e){this.tab=e,this.tabs();let t=++this.stamp;if(this.extra.replaceChildren(),e==="block")return this.openBlock(t);if(e==="line")return this.openLine();let i=await Promise.all(this.runs.map(r=>r.table(e).catch(()=>null)));if(t!==this.stamp)return;this.curves=i.flatMap((r,a)=>r?VL(r,a>0):[]);let s=e==="histories"?'This run recorded no histories. Request them in the scene: [[outputs]] history = { field = "..." }':"This run has no energy.csv.";this.draw(s)}setPicked(e,t){this.picked=t===null?null:{run:e,id:t},this.tab==="block"&&this.open("block")}async openBlock(e){if(this.curves=[],!this.picked)return this.draw("Pick a block in the picture to see its history.");let{run:t,id:i}=this.picked,s=ll(t);s.includes(this.blockField)||(this.blockField=s[0]??""),this.extra.replaceChildren(J("span",{},`${t.called(i)}: `),di(s.map(o=>[o,o]),this.blockField,o=>{this.blockField=o,this.open("block")},"field of the block")),this.draw("Reading the frames \u2026");let r=t.moments(),a=r.length>1&&r.every(o=>o.time===r[0].time);await t.history(i,this.blockField,(o,l)=>{if(e!==this.stamp)return!1;let c=r.slice(0,o.length).map(h=>a?h.step:h.time);return this.curves=[{name:this.blockField,unit:l,x:c,bySteps:a,values:[...o],dash:!1}],this.draw(""),!0})}changed(){this.tab==="line"&&this.object.offsetParent!==null&&this.openLine()}openLine(){let e=this.lines();this.extra.replaceChildren(),e.some(t=>t.parts.length>0)&&this.extra.append(J("button",{type:"button",title:"The values as a table (CSV)",onclick:()=>Gr(new Blob([zL(e)],{type:"text/csv"}),HL(e))},"CSV")),this.curves=e.filter(t=>t.parts.length>0).map(BL),this.draw("Press d and click two points of the picture to see the field along the line between them.")}mark(e){this.now=e;for(let t of this.plots)t.redraw(!1)}draw(e){for(let i of this.plots)i.destroy();if(this.plots=[],this.body.replaceChildren(),this.curves.length===0){this.body.append(J("p.hint",{},e));return}let t=new Map;for(let i of this.curves){let s=`${i.unit==="-"?`- ${i.name}`:i.unit} ${i.bySteps} ${i.along??""}`;t.set(s,[...t.get(s)??[],i])}for(let i of t.values())this.body.append(this.one(i));this.resize()}one(e){let t=e[0].unit==="-"?"":e[0].unit,{bySteps:i,along:s}=e[0],r=J("figure.chart",{}),a=getComputedStyle(document.documentElement),o=a.getPropertyValue("--ink2").trim(),l=a.getPropertyValue("--line").trim(),c=a.getPropertyValue("--accent").trim(),h=[...new Set(e.map(v=>v.name))],u=e.every(v=>/unbalanced/.test(v.name)),f=(v,m)=>m.map(g=>g===null?"":qt(g)),d={width:300,height:180,title:(s?`${s}`:"")+(h.length===1?h[0]+(t?` [${t}]`:""):t?`[${t}]`:""),cursor:{sync:{key:s===void 0?"riprap":"riprap line"},drag:{x:!0,y:!1}},legend:{live:!0},scales:{x:{time:!1},y:u?{distr:3}:{}},axes:[{stroke:o,grid:{stroke:l,width:1},ticks:{stroke:l,width:1},size:28,values:f},{stroke:o,grid:{stroke:l,width:1},ticks:{stroke:l,width:1},size:62,values:f}],series:[{label:s!==void 0?"distance [m]":i?"step":"time [s]",value:(v,m)=>m===null?"\u2013":qt(m)},...e.map((v,m)=>({label:v.dash?`${v.name} (2)`:v.name,stroke:Od[h.indexOf(v.name)%Od.length]??Od[m%Od.length],width:1.4,...v.dash?{dash:[6,4]}:{},points:{show:v.x.length<40&&s===void 0,size:4},spanGaps:s===void 0,value:(g,y)=>y==null?"\u2013":qt(y)}))],hooks:{draw:[v=>{if(s!==void 0)return;let m=v.valToPos((i?this.now?.step:this.now?.time)??0,"x",!0),{left:g,top:y,width:_,height:x}=v.bbox;m<g||m>g+_||(v.ctx.save(),v.ctx.strokeStyle=c,v.ctx.setLineDash([]),v.ctx.lineWidth=1.5*devicePixelRatio,v.ctx.beginPath(),v.ctx.moveTo(m,y),v.ctx.lineTo(m,y+x),v.ctx.stroke(),v.ctx.restore())}]}},p=new ni(d,WL(e,u),r);return p.over.addEventListener("click",()=>{let{left:v}=p.cursor;s===void 0&&v!==void 0&&v!==null&&v>=0&&this.seek(p.posToVal(v,"x"),i)}),this.plots.push(p),r}resize(){let e=this.plots.length;if(e===0)return;let t=this.body.clientWidth,i=Math.max(1,Math.min(e,Math.floor(t/300))),s=Math.floor((t-24)/i)-12,r=e>i?190:Math.max(150,this.body.clientHeight-66);for(let a of this.plots)a.setSize({width:s,height:Math.min(r,320)})}retheme(){this.curves.length>0&&this.draw("")}};function BL({run:n,field:e,unit:t,parts:i},s,r){let a=[],o=[];i.forEach(({from:c,to:h,value:u},f)=>{f>0&&c>i[f-1].to*(1+1e-9)&&(a.push(.5*(i[f-1].to+c)),o.push(null)),a.push(c,h),o.push(u,u)});let l=r.length>1?`${n.summary.name}: `:"";return{name:e,unit:t,x:a,bySteps:!1,values:o,dash:!1,along:l}}function sw(n){return/[",\n]/.test(n)?`"${n.replaceAll('"','""')}"`:n}function zL(n){let{field:e,unit:t}=n[0],i=n.length>1,s=[...i?["run"]:[],"from [m]","to [m]","block","name",t==="-"?e:`${e} [${t}]`],r=n.flatMap(({run:a,parts:o})=>o.map(l=>[...i?[sw(a.summary.name)]:[],l.from,l.to,l.block,sw(a.called(l.block)),l.value].join(",")));return[s.join(","),...r,""].join(`
`)}function HL(n){return`${n[0].run.summary.name.replace(/\.run$/,"")}_${n[0].field}_line.csv`}function VL(n,e){return n.names.map((t,i)=>({name:t,unit:n.units[i],x:n.x,bySteps:n.bySteps,values:n.columns[i],dash:e}))}function ll(n){return n.summary.names??GL(n.summary.fields??[])}function GL(n){return n.flatMap(e=>e.components===1?[e.name]:[e.name,...["x","y","z"].slice(0,e.components).map(t=>`${e.name}.${t}`)])}function WL(n,e){let t=n.map(s=>{let r=Array.from(s.x),a=Array.from(s.values,o=>o===null||!Number.isFinite(o)||e&&o<=0?null:o);return[r,a]}),i=n[0].x;return n.every(s=>s.x===i)?[t[0][0],...t.map(s=>s[1])]:ni.join(t)}var Bd=class{constructor(e,t,i,s,r){this.runs=e;this.choices=t;this.actions=i;this.saved=s;this.dimension=r;this.object=J("aside.panel",{"aria-label":"settings"}),this.rebuild(),t.listen(a=>{let o=["clipAt","clipDip","clipDirection","vectorSize"];(!this.object.querySelector("input[type=range]:active, input[type=range]:focus")||!a.every(c=>o.includes(c)))&&this.refill()})}runs;choices;actions;saved;dimension;object;blockBox=J("div.numbers");status=J("div.exportstate",{role:"status"});colourBox=J("div");moveBox=J("div");marksBox=J("div");rebuild(e=this.dimension){this.dimension=e;let t=this.runs.filter(i=>i.summary.manifest?.preview&&i.summary.manifest.warnings.length>0);this.object.replaceChildren(...t.map(i=>oa(`Warnings (${i.summary.manifest.warnings.length})`,!0,...this.warnings(i))),oa("Colour",!0,this.colourBox),oa("Shape and view",!0,this.moveBox),oa("Vectors and contacts",!0,this.marksBox),oa("Block",!0,this.blockBox),oa("Views",!1,this.saved.object),oa("Save",!1,this.saveBox()),...this.runs.map((i,s)=>oa(this.runs.length>1?`Run ${s+1}`:"Run",!1,XL(i,this.warnings(i))))),this.refill(),this.blockBox.hasChildNodes()||this.showBlock(null)}warnings(e){return(e.summary.manifest?.warnings??[]).map(t=>{let i=rd(t,e.names);if(i.length===0)return J("p.warning",{},t);let s=i.length===1?"Go to this block":`Go to these ${i.length} blocks`;return J("button.warning",{type:"button",title:s,onclick:()=>this.actions.goTo(e,i)},t)})}refill(){this.colourBox.replaceChildren(...this.colourRows()),this.moveBox.replaceChildren(...this.moveRows()),this.marksBox.replaceChildren(...this.markRows())}colourRows(){let{choices:e}=this,t=e.now,i=[...new Set(this.runs.flatMap(l=>ll(l)))],s=di([["","one colour"],...i.map(l=>[l,l])],t.field,l=>e.set(zd(t,l)),"field"),r=w0(this.runs).map(l=>{let c=()=>e.set(zd(t,l));return J("button",{type:"button",title:"Colour by this field (q: the next)","aria-pressed":String(l===t.field),onclick:c},l||"one colour")}),a=[kn("Field",s)];r.length>1&&a.push(J("div.buttons",{},...r));let o=this.meaning(t.field);if(o&&a.push(J("p.hint",{},o)),!t.field||Pr.has(t.field))return a;if(a.push(kn("Colours",di(Object.keys(Aa).map(l=>[l,l]),t.map,l=>e.set({map:l}),"colour map")),kn("Range",di([["most","run, 98 % of blocks"],["run","whole run"],["frame","this frame"],["fixed","fixed"]],t.rangeMode,l=>{let[c,h]=this.actions.range();e.set({rangeMode:l,low:c,high:h})},"range of the colours"))),t.rangeMode==="fixed"){let l=(c,h)=>{let u=J("input",{type:"number",step:"any",value:String(t[c]),"aria-label":h});return u.addEventListener("change",()=>{Number.isFinite(u.valueAsNumber)&&e.set({[c]:u.valueAsNumber})}),u};a.push(kn("From, to (SI)",l("low","lowest value"),l("high","highest value")))}return a.push(J("div.checks",{},si("powers of ten",t.log,l=>e.set(l&&t.map==="blue-red"?{log:l,map:"light"}:{log:l}),"Logarithmic colours"),si("only in range",t.only,l=>e.set({only:l}),"Hide blocks whose value is outside the range"))),a}kindOf(e,t){if(t===void 0)return"";let i=this.runs.filter(s=>s.summary.manifest).map(s=>yg(s,e,t));return i.every(s=>s===i[0])?i[0]??"":""}meaning(e){let t=e.replace(/\.(x|y|z|magnitude)$/,"");for(let i of this.runs){let s=i.summary.manifest?.fields?.find(r=>r.name===t||r.name===`block.${t}`);if(s)return s.meaning}return""}moveRows(){let{choices:e,actions:t}=this,i=e.now,s=J("input",{type:"range",min:"0",max:"4",step:"0.02",value:String(Math.log10(Math.max(1,i.exaggeration))),"aria-label":"exaggeration"}),r=J("output",{},`\xD7 ${qt(i.exaggeration,3)}`),a=()=>Number((10**Number(s.value)).toPrecision(2));s.addEventListener("input",()=>r.textContent=`\xD7 ${qt(a(),3)}`),s.addEventListener("change",()=>e.set({exaggeration:a()}));let o=(c,h,u)=>J("button",{type:"button",title:h,onclick:u},c);return[kn("Displacement",s,r),J("div.buttons",{},o("true","Displacements as they are",()=>e.set({exaggeration:1})),o("visible","Exaggerate so that the largest displacement can be seen",()=>e.set({exaggeration:t.niceExaggeration()})),o("fit","All in view (f)",()=>t.fit()),...this.dimension===3?["x","y","z"].map(c=>o(c,`Look along ${c}`,()=>t.fit(c))):[],o("line","Distance, and the field along a line: click both ends; again: remove it (d)",t.line)),J("div.checks",{},si("edges",i.edges,c=>e.set({edges:c}),"Draw the edges of the blocks (e)"),this.dimension===3?si("shadows",i.shadows,c=>e.set({shadows:c}),"Shadows of the sun, and darker hollows (y)"):null,this.runs.some(c=>c.hasField("held"))?si("supports",i.supports,c=>e.set({supports:c}),"Outline the blocks that supports hold or move (u)"):null,...this.conditionChecks()),...(i.shadows||i.edges)&&t.unshaded()?[J("p.hint",{},t.unshaded())]:[],kn("Joints",di([["","not shown"],["set","by set (direction)"],...this.runs.some(c=>c.conditions)?[["interface","by interface"]]:[]],i.joints,c=>e.set({joints:c}),"joints")),...this.cutRows()]}conditionChecks(){let{choices:e}=this,t=e.now,i=this.runs.flatMap(r=>r.conditions??[]),s=[];return i.some(r=>r.faces.length>0)&&s.push(si("boundaries",t.boundaries,r=>e.set({boundaries:r}),"Colour the faces that are held, moved, viscous or loaded (h)")),i.some(r=>r.loads.length>0||r.faces.some(a=>a.kind==="loaded"))&&s.push(si("loads",t.loads,r=>e.set({loads:r}),"Arrows of given forces and pressures, at their full size (l)")),i.some(r=>r.water.length>0)&&s.push(si("water table",t.water,r=>e.set({water:r}),"The water table of the phase (w)")),s}cutRows(){let{choices:e}=this,t=e.now,i=this.dimension===3?["x","y","z"]:["x","y"],s=di([["","nothing"],...i.map(l=>[l,`along ${l}`]),["free",this.dimension===3?"any plane":"any line"]],t.clipAxis,l=>e.set({clipAxis:l}),"clipping plane"),r=[kn("Cut away",s)];if(!t.clipAxis)return r;let a=(l,c,h,u)=>{let f=J("input",{type:"range",min:"0",max:String(c),step:String(h),value:String(t[l]),"aria-label":u}),d=l==="clipAt"?null:J("output",{},`${t[l]}\xB0`);return f.addEventListener("input",()=>{d&&(d.textContent=`${f.value}\xB0`),e.set({[l]:Number(f.value)})}),[f,d]},o=di([["flat","flat, through blocks"],["whole","whole blocks"]],t.clipFlat?"flat":"whole",l=>e.set({clipFlat:l==="flat"}),"kind of cut");return o.title="Flat, or whole blocks (b)",r.push(kn("Cut is",o),kn("Plane at",...a("clipAt",1,.002,"place of the cut"))),t.clipAxis==="free"&&(this.dimension===2?r.push(kn("Angle from x",...a("clipDip",180,1,"angle of the cut"))):r.push(kn("Dip",...a("clipDip",90,1,"dip of the cut")),kn("Dip direction",...a("clipDirection",360,1,"dip direction of the cut")))),r.push(J("div.checks",{},si("flip",t.clipFlip,l=>e.set({clipFlip:l}),"Remove the other side (o)"))),r}markRows(){let{choices:e}=this,t=e.now,i=new Set(this.runs.flatMap(p=>(p.summary.fields??[]).filter(v=>v.components>1).map(v=>v.name))),s=["displacement","velocity","force"].filter(p=>i.has(p)),r=this.runs.map(p=>p.summary.held).filter(p=>p!==void 0),a=s.filter(p=>r.every(v=>v.vectors.includes(p))),o=r.every(p=>p.contacts),c=s.length>a.length||!o?[J("p.hint",{},"This report holds only part of the arrows and contacts; riprap view shows all.")]:[],h=this.runs.some(p=>p.hasStress);if(a.length===0&&!o&&!h)return c;let u=this.runs.some(p=>p.conditions?.water.some(v=>v.seeps)),f=o?["contact force",...u?["seepage flow"]:[]]:[],d=[kn("Arrows",di([["","none"],...[...a,...f].map(p=>[p,p])],t.vectors,p=>e.set({vectors:p}),"vectors"))];if(h&&d.push(J("div.checks",{},si("stress",t.stress,p=>e.set({stress:p}),"Principal stresses as crosses: blue in compression, red in tension (a)"))),t.vectors||t.stress||t.chains){let p=J("input",{type:"range",min:"-1",max:"1",step:"0.05",value:String(Math.log10(t.vectorSize)),"aria-label":"size of arrows, crosses and chains"});p.addEventListener("input",()=>e.set({vectorSize:10**Number(p.value)})),d.push(kn("Size",p))}if(this.runs.some(p=>p.frames>1)&&d.push(...this.trailRows()),!o)return[...d,...c];if(d.push(J("div.checks",{},si("contacts",t.contacts,p=>e.set({contacts:p}),"Points at contacts, coloured by state (c)"),si("force chains",t.chains,p=>e.set({chains:p}),"Tubes from block to block, as thick and dark as the contact force (n)"),this.dimension===3?si("cracks",t.cracks,p=>e.set({cracks:p}),"Broken and open faces between glassy blocks (k)"):null,this.runs.some(p=>p.summary.bolts)?si("bolts",t.bolts,p=>e.set({bolts:p}),"Bars of bolts, red in tension, blue in compression (r)"):null,this.runs.some(p=>(p.summary.manifest?.sources??[]).length>0)?si("charges",t.charges,p=>e.set({charges:p}),"Stars where charges are (i)"):null)),t.contacts){let p=this.actions.states();d.push(J("div.checks",{},...Ir.flatMap((v,m)=>{if(m>1&&!p[m])return[];let g=si(v.name,t.states[m],y=>e.set({states:t.states.map((_,x)=>x===m?y:_)}));return g.style.setProperty("--chip",v.colour),g.classList.add("chipped"),g})))}return[...d,...c]}trailRows(){let{choices:e}=this,{trails:t,trailColour:i}=e.now,s=[["","none"],["moving","of all that moved"],["picked","of the picked block"]],r=[["speed","by speed"],["block","by block"]];return[kn("Trails",di(s,t,a=>e.set({trails:a}),"trails")),...t?[kn("Coloured",di(r,i,a=>e.set({trailColour:a}),"colour of trails"))]:[]]}saveBox(){let e=(i,s,r)=>J("button",{type:"button",title:s,onclick:r},i),t=e("MP4","",()=>this.actions.film("mp4"));return t.hidden=!0,R_().then(i=>{i!==null&&(t.hidden=!1,t.textContent=`MP4 (${i})`,t.title=`The same film as MP4, its pictures in ${i}${i==="H.264"?"":", which slides and older players may not show"}`)}),J("div",{},J("div.buttons",{},e("Picture","PNG of what is shown (s)",this.actions.picture),e("All frames","PNG of every frame, in a zip",this.actions.sequence),e("Film","WebM with every frame once, at the frames per second of the bar below",()=>this.actions.film("webm")),t),this.saved.pathRow(this.dimension),this.status)}say(e){this.status.textContent=e}showBlock(e,t=""){if(!e){this.blockBox.replaceChildren(J("p.hint",{},t||"Click a block to see its numbers and their history."));return}let i=e.columns.filter(r=>r.name!=="block").map(r=>{let a=r.values.map(h=>typeof h=="number"?h:Number.NaN),o=a.length>1?`${pn(Math.hypot(...a),r.unit)}`:r.unit==="-"?qt(a[0]??Number.NaN):pn(a[0]??Number.NaN,r.unit),l=Pr.has(r.name)?this.kindOf(r.name,a[0]):"",c=a.length>1?`(${a.map(h=>qt(h,3)).join(", ")})`:"";return J("tr",{},J("td",{},r.name),J("td",{},l||o,c?J("small",{},c):null))}),s=e.groups.length?[rw(e.groups.length>1?"groups":"group",e.groups.join(", "))]:[];this.blockBox.replaceChildren(J("div.buttons.pickhead",{},J("b",{},e.name||`block ${e.block}`),J("button",{type:"button",onclick:this.actions.history},"history"),J("button",{type:"button",onclick:this.actions.unpick,title:"Deselect (Esc)"},"clear")),J("table",{},...e.name?[rw("number",String(e.block))]:[],...s,...i))}};function w0(n){let e=new Set(n.flatMap(t=>ll(t)));return[e.has("material")?"material":"",...["displacement","velocity"].filter(t=>e.has(t))]}function zd(n,e){return{field:e,map:Cf(e),log:!1,rangeMode:n.rangeMode==="fixed"?"most":n.rangeMode}}function rw(n,e){return J("tr",{},J("td",{},n),J("td",{},e))}function oa(n,e,...t){return J("details",{open:e},J("summary",{},n),...t)}function XL(n,e){let{manifest:t,name:i}=n.summary;if(!t)return J("p.hint",{},"This folder cannot be read.");let s=[["folder",i],["scene",t.scenario],["case",[t.variant,t.case].filter((o,l,c)=>o&&o!=="default"&&c.indexOf(o)===l).join(", ")],["ended",t.ended+(t.message?`: ${t.message}`:"")],["model time",pn(t.time,"s")],["steps",t.steps.toLocaleString("en")],["time step",pn(t.dt,"s")],["wall time",`${qt(t.wall_time,3)} s on ${t.threads} thread${t.threads===1?"":"s"}`],["started",t.started.replace("T"," ").replace("Z"," UTC")],["riprap",t.riprap],["state hash",t.state_hash.slice(0,16)]],a=["scenario.resolved.toml","manifest.json","histories.csv","energy.csv","events.jsonl"].flatMap(o=>{let l=n.source.file(o);return l?[J("a",{href:l,target:"_blank",rel:"noopener"},o)," "]:[]});return J("div",{},J("table",{},...s.filter(([,o])=>o).map(([o,l])=>J("tr",{},J("td",{},o),J("td",{},l)))),...t.preview?[]:e,J("p.files",{},...a))}var Kc={field:"material",map:"light",rangeMode:"most",low:0,high:1,log:!1,exaggeration:1,edges:!0,shadows:!0,supports:!1,boundaries:!1,loads:!1,water:!0,joints:"",clipAxis:"",clipAt:.5,clipFlip:!1,clipFlat:!0,clipDip:60,clipDirection:240,only:!1,vectors:"",vectorSize:1,stress:!1,contacts:!1,states:[!1,!0,!0,!0,!0,!0,!0,!0],cracks:!1,bolts:!0,chains:!1,trails:"",trailColour:"speed",notes:!0,charges:!0,speed:10,loop:!0},Hd=class{now={...Kc,states:[...Kc.states]};listeners=[];set(e){Object.assign(this.now,e);for(let t of this.listeners)t(Object.keys(e))}listen(e){this.listeners.push(e)}};var S0=n=>n.toArray();function $L(n,e,t){let{stage:i,scale:s}=n,r=new P(...n.blocks.shape.info.origin),{position:a,target:o,zoom:l}=i.standpoint(),c=e.field!==""&&!Pr.has(e.field),h=Object.entries(e).filter(([u,f])=>JSON.stringify(f)!==JSON.stringify(Kc[u]));return{name:t,eye:S0(a.add(r)),target:S0(o.add(r)),up:S0(i.camera.up),angle:i.camera instanceof En?i.camera.fov:null,zoom:l,field:e.field,log:e.log,range:c?[s.low,s.high]:null,exaggeration:e.exaggeration,cut:n.cutAway(e),bolts:e.bolts,...e.trails==="picked"&&n.picked!==null?{picked:n.picked}:{},settings:Object.fromEntries(h)}}function lw(n,e){let t=new P(...n.blocks.shape.info.origin);return{position:new P(...e.eye).sub(t),target:new P(...e.target).sub(t),zoom:e.zoom}}function qL(n,e,t){if(e==="views"&&t.length>1){let i=t.map(l=>lw(n,l)),s=new _a(i.map(l=>l.position)),r=i.map(l=>l.target),o=r.every(l=>l.distanceTo(r[0])<1e-9)?null:new _a(r);return l=>{let c=l*(i.length-1),h=Math.min(i.length-2,Math.floor(c)),u=Kn.lerp(i[h].zoom,i[h+1].zoom,c-h);return{position:s.getPoint(l),target:o?.getPoint(l)??r[0].clone(),zoom:u}}}if(e==="round"&&!n.flat){let{position:i,target:s,zoom:r}=n.stage.standpoint(),a=n.stage.camera.up.clone().normalize();return o=>({position:i.clone().sub(s).applyAxisAngle(a,2*Math.PI*o).add(s),target:s.clone(),zoom:r})}return null}function aw(n){return Array.isArray(n)&&n.length===3&&n.every(e=>Number.isFinite(e))}function ow(n){let e=i=>new Dn(`views.json: ${i}.`,"Save the file again from the viewer."),t;try{t=JSON.parse(n).views}catch(i){throw e(String(i))}if(!Array.isArray(t))throw e("it has no list `views`");return t.map((i,s)=>{let{name:r,eye:a,target:o}=i;if(typeof r!="string"||!aw(a)||!aw(o))throw e(`view ${s+1} needs a name, an eye and a target`);return{...{up:[0,0,1],angle:32,zoom:1,field:"displacement",log:!1,range:null,exaggeration:1,cut:null,bolts:!0},...i,name:r,eye:a,target:o,settings:i.settings??{}}})}var Vd=class{constructor(e,t,i){this.views=e;this.choices=t;this.annotate=i;let s=J("input",{type:"text",placeholder:"name","aria-label":"name of the view",maxLength:60}),r=()=>{this.add(s.value.trim()||`view ${this.all.length+1}`),s.value=""};s.addEventListener("keydown",o=>{o.key==="Enter"&&r()});let a=(o,l,c)=>J("button",{type:"button",title:l,onclick:c},o);this.object.append(J("div.buttons",{},s,a("save view","Keep camera, colours and cut under this name",r),a("views.json","All saved views in a file: riprap shot RUN --views FILE --saved NAME draws them; in the run folder the viewer finds them again",()=>this.write())),this.list,this.noteRow(),this.noteList,this.said),this.fill()}views;choices;annotate;object=J("div");path="";all=[];notes=[];noteList=J("div.buttons");said=J("p.hint",{role:"status"});list=J("div.buttons");noteRow(){let e=J("input",{type:"text",placeholder:"text","aria-label":"text of the note",maxLength:dg}),t=()=>{let i=e.value.trim();if(!i){this.said.textContent="Write a text first, then click its place.";return}this.said.textContent="Click its place: on a block it goes along with it.",this.annotate(i),e.value="",e.blur()};return e.addEventListener("keydown",i=>{i.key==="Enter"&&t()}),J("div.buttons",{},e,J("button",{type:"button",title:"Put this text on a block or a place of the model; it is kept with the views, and in pictures and films",onclick:t},"note"))}addNote(e){this.notes.push(e),this.kept()}pathRow(e){let t=[["","stays"],["views","through the saved views"],...e===3?[["round","once around"]]:[]];return kn("Camera",di(t,this.path,i=>this.path=i,"camera of a film"))}move(){if(this.path==="views"&&this.all.length<2)throw new Error("Save two views or more: the camera goes through them in their order.");let e=this.views()[0];return e?.blocks?qL(e,this.path,this.all):null}async load(){let e=this.views()[0]?.run;if(e){try{let t=localStorage.getItem(this.key());t&&([this.all,this.notes]=[ow(t),pg(t)])}catch{}try{let t=e.summary.views?e.source.file("views.json"):void 0,i=t?await(await fetch(t)).text():null;if(i!==null){for(let r of ow(i))this.put(r);let s=(r,a)=>r.text===a.text&&r.block===a.block&&r.at.every((o,l)=>o===a.at[l]);for(let r of pg(i))this.notes.some(a=>s(r,a))||this.notes.push(r)}}catch(t){this.said.textContent=t instanceof Dn?`${t.what} ${t.hint}`:String(t)}this.fill()}}key(){return`riprap.views.${this.views()[0]?.run.summary.name??""}`}put(e){let t=this.all.findIndex(i=>i.name===e.name);t<0?this.all.push(e):this.all[t]=e}add(e){let t=this.views()[0];t?.blocks&&(this.put($L(t,this.choices.now,e)),this.kept())}kept(){this.fill();try{localStorage.setItem(this.key(),this.text())}catch{}}text(){return JSON.stringify({views:this.all,notes:this.notes},null,1)}write(){this.all.length+this.notes.length===0?this.said.textContent="No views and no notes saved yet.":Gr(new Blob([this.text()],{type:"application/json"}),"views.json")}fill(){this.list.replaceChildren(...this.all.map(e=>J("span.saved",{},J("button",{type:"button",title:"Go to this view",onclick:()=>this.go(e)},e.name),J("button",{type:"button",title:`Remove ${e.name}`,"aria-label":`remove ${e.name}`,onclick:()=>this.remove(e)},"\xD7")))),this.noteList.replaceChildren(...this.notes.map(e=>{let t=()=>{this.notes=this.notes.filter(i=>i!==e),this.kept()};return J("span.saved",{},J("span",{},e.text),J("button",{type:"button",title:"Remove this note","aria-label":`remove note ${e.text}`,onclick:t},"\xD7"))})),this.said.textContent="";for(let e of this.views())e.notes=this.notes,e.stage.redraw()}remove(e){this.all=this.all.filter(t=>t!==e),this.kept()}go(e){let{states:t,...i}={...Kc,...e.settings,field:e.field};this.choices.set({...i,states:[...t]});for(let s of this.views())s.blocks&&s.stage.follow(lw(s,e))}};var Gd=class{constructor(e,t,i){this.choices=e;this.show=t;this.ahead=i;this.slider=J("input.scrub",{type:"range",min:"0",max:"0",step:"1",value:"0","aria-label":"time"}),this.slider.addEventListener("input",()=>{this.pause(),this.following=!1,this.go(Number(this.slider.value))}),this.label=J("output.time",{"aria-live":"off"}),this.playButton=rs("play","Play (space)",()=>this.toggle()),this.playButton.classList.add("primary");let s=[1,2,5,10,20,30].map(a=>[String(a),`${a}/s`]),r=di(s,String(e.now.speed),a=>e.set({speed:Number(a)}),"frames per second");r.title="Frames per second",this.object=J("div.timeline",{},rs("first","First frame (Home)",()=>{this.go(0)}),rs("back","One frame back (\u2190)",()=>this.step(-1)),this.playButton,rs("next","One frame forward (\u2192)",()=>this.step(1)),rs("last","Last frame (End)",()=>{this.go(this.moments.length-1)}),this.slider,this.label,r)}choices;show;ahead;object;moments=[];at=0;playing=!1;following=!1;slider;label;playButton;busy=!1;wanted=null;setMoments(e){this.moments=e,this.slider.max=String(Math.max(0,e.length-1)),this.object.classList.toggle("empty",e.length===0),this.say()}say(){let e=this.moments[this.at],t=e?hg(e):"";this.slider.value=String(this.at),this.label.replaceChildren(J("b",{title:t},t||"no frames"),J("small",{},this.moments.length?`${this.at+1} of ${this.moments.length}`:"")),this.slider.setAttribute("aria-valuetext",t)}async go(e){let t=this.moments.length-1;if(this.at=Math.min(Math.max(0,e),Math.max(0,t)),this.say(),!(t<0)){if(this.busy){this.wanted=this.at;return}this.busy=!0;try{await this.show(this.moments[this.at])}finally{this.busy=!1}if(this.wanted!==null){let i=this.wanted;this.wanted=null,i!==e&&await this.go(i)}}}async seek(e,t){let i=r=>Math.abs((t?r.step:r.time)-e),s=0;this.moments.forEach((r,a)=>{i(r)<i(this.moments[s])&&(s=a)}),this.following=!1,await this.go(s)}step(e){this.pause(),this.following=!1,this.go(this.at+e)}toggle(){this.playing?this.pause():this.play()}pause(){this.playing=!1,this.face()}face(){this.playButton.replaceChildren(ip(this.playing?"pause":"play"));let e=this.playing?"Pause (space)":"Play (space)";this.playButton.title=e,this.playButton.setAttribute("aria-label",e)}async play(){if(!(this.playing||this.moments.length<2)){for(this.playing=!0,this.following=!1,this.face(),this.at>=this.moments.length-1&&await this.go(0);this.playing;){let e=performance.now();if(this.at>=this.moments.length-1&&!this.choices.now.loop)break;let t=(this.at+1)%this.moments.length;for(let s of[1,2]){let r=this.moments[(t+s)%this.moments.length];r!==void 0&&this.ahead(r)}await this.go(t),await new Promise(s=>requestAnimationFrame(s));let i=1e3/this.choices.now.speed-(performance.now()-e);i>1&&await new Promise(s=>setTimeout(s,i))}this.pause()}}};var hw="riprap-theme",uw=window.matchMedia("(prefers-color-scheme: dark)"),Wd=document.documentElement,YL=Wd.dataset.theme;function jL(){try{return localStorage.getItem(hw)}catch{return null}}function cw(){Wd.dataset.theme=jL()??YL??(uw.matches?"dark":"light")}function Xd(n=()=>{}){cw(),uw.addEventListener("change",()=>{cw(),n()})}function fw(){let n=Wd.dataset.theme==="dark"?"light":"dark";Wd.dataset.theme=n;try{localStorage.setItem(hw,n)}catch{}}var JL=1e3,KL=["field","rangeMode","vectors","contacts","cracks","bolts","chains","stress","supports","joints"],$d=class{constructor(e,t){this.host=e;this.loading=t}host;loading;choices=new Hd;runs=[];panes=[];silent=new Set;timeline;panel=null;plots=null;saved=new Vd(()=>this.panes.map(({view:e})=>e),this.choices,e=>this.setMeasuring(!0,e));stages=J("div.stages");badge=J("span.badge");title=J("h1");measuring=!1;writing="";work=null;async start(e){this.runs=await Promise.all(e.map(a=>qf.open(a)));let t=this.runs.filter(a=>!a.summary.problem);await Promise.all(t.map(a=>a.readModel())),this.chooseField(t),this.timeline=new Gd(this.choices,a=>this.showMoment(a),a=>{for(let{view:o}of this.panes)o.prefetch(o.run.frameAt(a),this.choices.now)}),this.layout(t);for(let{view:a}of this.panes)a.others=t.filter(o=>o!==a.run);this.timeline.setMoments(this.moments(t)),this.refreshHead(),t.some(a=>a.summary.live)&&(this.timeline.following=!0,this.news());for(let{view:a}of this.panes)a.hasty=!0;await this.timeline.go(this.timeline.moments.length-1);for(let a of this.panes)this.refreshPane(a);let[i,...s]=this.panes;if(i)for(let a of s)a.view.stage.follow(i.view.stage.standpoint());let r=this.panes[0]?.view.flat??!0;this.panel?.rebuild(r?2:3),this.panel?.refill(),document.documentElement.dataset.shown="true";for(let{view:a}of this.panes)a.hasty=!1;await this.timeline.go(this.timeline.at),await this.saved.load(),document.documentElement.dataset.ready="true"}chooseField(e){let t=e.flatMap(i=>ll(i));t.includes("removable_type")&&(this.choices.now.field="removable_type"),t.includes(this.choices.now.field)||(this.choices.now.field=""),this.choices.now.map=Cf(this.choices.now.field)}moments(e){let t=(s,r)=>s.time-r.time||s.nth-r.nth,i=e.flatMap(s=>s.moments()).sort(t);return i.filter((s,r)=>r===0||t(s,i[r-1])>0)}layout(e){for(let l of this.runs)l.summary.problem?this.stages.append(QL(l.summary.name,l.summary.problem)):this.addPane(l);let t=e[0],i=t?.summary.fields.some(l=>l.components===3)?3:2;this.panel=new Bd(this.runs,this.choices,this.actions(),this.saved,i),this.plots=new kd(e,(l,c)=>{this.timeline.seek(l,c)},()=>this.lines());let s=this.shortcuts(),r=I_(s);P_(s,this.host);let a=l=>()=>{this.host.classList.toggle(l),l==="with-plots"&&this.openPlots()},o=J("header",{},this.title,this.badge,J("span.spacer"),rs("camera","Save a picture (s)",()=>{this.save("picture")}),rs("plots","Histories (p)",a("with-plots")),rs("theme","Light or dark (t)",()=>this.flipTheme()),rs("help","Keys and mouse (?)",()=>r.showModal()),rs("menu","Panel (m)",a("no-panel")));this.host.replaceChildren(o,J("main",{},J("div.middle",{},this.stages,this.plots.object),this.panel.object),this.timeline.object,r,this.loading.object),window.innerWidth<760&&this.host.classList.add("no-panel"),this.choices.listen(l=>{this.changed(l)}),Xd(()=>this.themed()),this.themed(),e.length>0&&t.summary.tables[0]&&window.innerHeight>820&&window.innerWidth>1100&&(this.host.classList.add("with-plots"),this.openPlots())}addPane(e){let t=J("div.stage"),i={host:t,view:new od(e,t,this.loading),legend:J("div.legendhost"),banner:J("div.banner",{role:"alert",hidden:!0}),head:J("div.panehead"),triad:J("div.triad",{"aria-hidden":"true"}),notes:J("div.notes")};t.append(i.notes,i.head,i.legend,i.banner,i.triad),this.stages.append(t),this.panes.push(i);let{view:s}=i;s.stage.onMove=a=>{for(let o of this.panes)o!==i&&o.view.stage.follow(a)},s.stage.onDrawn=()=>{tD(i),i.notes.replaceChildren(...qx(s.labels()))},s.onChange=()=>this.refreshPane(i);let r=null;s.stage.canvas.addEventListener("pointerdown",a=>r=[a.clientX,a.clientY]),s.stage.canvas.addEventListener("pointerup",a=>{r&&Math.hypot(a.clientX-r[0],a.clientY-r[1])<5&&a.button===0&&(this.writing?this.write(s,a.clientX,a.clientY):this.measuring?this.measure(s,a.clientX,a.clientY):this.pick(i,s.pickAt(a.clientX,a.clientY))),r=null}),s.stage.canvas.addEventListener("webglcontextlost",a=>{a.preventDefault(),this.banner(i,{what:"The browser has lost its graphics context.",hint:"Reload the page."})}),e.frames===0&&this.banner(i,M0(e))}measure(e,t,i){let s=e.placeAt(t,i);if(!s)return;let r=e.ends.length===1?[e.ends[0],s]:[s];this.layLine(r),!(r.length<2)&&(this.setMeasuring(!1),this.host.classList.add("with-plots"),this.plots?.open("line"))}layLine(e){for(let t of this.panes)t.view.lay(e),this.refreshPane(t);this.plots?.changed()}write(e,t,i){let s=e.placeAt(t,i);!s||!e.blocks||!e.motion||(this.saved.addNote($x(this.writing,s,e.pickAt(t,i),e.blocks,e.motion,this.choices.now.exaggeration)),this.setMeasuring(!1))}setMeasuring(e,t=""){this.measuring=e,this.writing=t,this.host.classList.toggle("measuring",e)}lines(){let{field:e}=this.choices.now;return this.panes.flatMap(({view:t})=>{let{pieces:i,length:s}=t.along();if(!t.values||s===0)return[];let r=i.map(a=>({from:a.from*s,to:a.to*s,block:t.blocks.ids[a.block],value:t.values[a.block]}));return[{run:t.run,field:e,unit:t.unit,length:s,parts:r}]})}async showMoment(e){await Promise.all(this.panes.map(({view:i})=>i.show(i.run.frameAt(e),this.choices.now)));for(let i of this.panes)this.refreshPane(i);this.plots?.mark(e),this.plots?.changed();let t=this.panes.find(i=>i.view.picked!==null);t&&!this.timeline.playing&&await this.showNumbers(t)}refreshPane(e){let{view:t}=e;e.legend.replaceChildren(e_(ld(t,this.choices.now),t.scale)),t.run.frames>0&&this.banner(e,t.trouble??t.run.summary.note??eD(t.run)),e.host.classList.toggle("stale",t.trouble!==null);let{summary:i}=t.run;if(this.runs.length>1){let s=t.run.saidAt(t.frame);e.head.replaceChildren(J("b",{},i.manifest.title||i.name),J("span",{},` ${i.name}${s?` \xB7 ${s}`:""}`))}t.stage.canvas.dataset.frame=String(t.frame),t.stage.canvas.dataset.faces=String(t.blocks?.visibleFaces??0),t.stage.canvas.dataset.blocks=String(t.blocks?.count??0),t.stage.canvas.dataset.cut=String(t.blocks?.cutBlocks??0)}banner(e,t){e.banner.hidden=t===null,t&&e.banner.replaceChildren(J("b",{},t.what),J("span",{},t.hint))}async changed(e){let t=this.choices.now;if(e.some(i=>KL.includes(i))){let i=this.timeline.moments[this.timeline.at];await Promise.all(this.panes.map(({view:s})=>s.show(i?s.run.frameAt(i):Math.max(0,s.frame),t))),(e.includes("contacts")||e.includes("chains"))&&this.panel?.refill()}else for(let{view:i}of this.panes)i.apply(t,e.includes("exaggeration"));for(let i of this.panes)this.refreshPane(i);this.plots?.changed()}async pick(e,t){for(let i of this.panes)i.view.pick(i===e?t:null);this.plots?.setPicked(e.view.run,t),t===null?this.panel?.showBlock(null):await this.showNumbers(e)}async showNumbers(e){let{view:t}=e;if(t.picked!==null)try{this.panel?.showBlock(await t.run.block(t.frame,t.picked))}catch(i){let{what:s,hint:r}=Lr(i);this.panel?.showBlock(null,`${s.replace(/\.$/,"")}. ${r}`)}}openPlots(){this.host.classList.contains("with-plots")&&this.plots?.open(this.plots.tab)}actions(){let e=()=>this.panes[0]?.view;return{fit:t=>{let i=e();if(i?.fit(t),i)for(let s of this.panes.slice(1))s.view.stage.follow(i.stage.standpoint())},picture:()=>{this.save("picture")},sequence:()=>{this.save("sequence")},film:t=>{this.save(t)},niceExaggeration:()=>Math.min(...this.panes.map(({view:t})=>t.niceExaggeration())),unpick:()=>{for(let t of this.panes)this.pick(t,null)},goTo:(t,i)=>{let s=this.panes.find(r=>r.view.run===t);if(s){s.view.goTo(i);for(let r of this.panes)r!==s&&r.view.stage.follow(s.view.stage.standpoint());this.pick(s,i[0]??null)}},line:()=>this.toggleLine(),history:()=>{this.host.classList.add("with-plots"),this.plots?.open("block")},range:()=>{let t=e()?.scale;return t?[t.low,t.high]:[0,1]},unshaded:()=>this.panes.map(({view:t})=>t.unshaded).find(t=>t!=="")??"",states:()=>Ir.map((t,i)=>this.panes.some(({view:s})=>(s.between?.counts[i]??0)>0))}}async save(e){let t=this.panes.filter(r=>r.view.blocks).map(r=>r.view);if(t.length===0)return;if(this.work){this.work.abort();return}let i=new AbortController;this.work=i;let s=r=>(this.panel?.say(`${Math.round(100*r)} %; choose it again to stop`),!i.signal.aborted);try{if(e==="picture")await E_(t,this.choices.now);else{let r=[t,this.choices.now,this.timeline,this.saved.move()];e==="sequence"?await A_(r,s):await C_(r,s,e)}this.panel?.say(i.signal.aborted?"stopped":"saved")}catch(r){this.panel?.say(Lr(r).what)}finally{this.work=null}}shortcuts(){let{choices:e,timeline:t}=this,i=this.actions(),s=c=>()=>e.set({exaggeration:Math.min(1e4,Math.max(1,Number((e.now.exaggeration*c).toPrecision(2))))}),r=()=>{let h=["","x","y","z","free"].filter(u=>u!=="z"||this.panes.some(({view:f})=>!f.flat));e.set({clipAxis:h[(h.indexOf(e.now.clipAxis)+1)%h.length]})},a=()=>{let c=w0(this.runs),h=c[(c.indexOf(e.now.field)+1)%c.length];h!==void 0&&e.set(zd(e.now,h))},o=()=>{let c=["","set","interface"];e.set({joints:c[(c.indexOf(e.now.joints)+1)%c.length]})},l=c=>h=>e.set({clipAt:Math.min(1,Math.max(0,Number((e.now.clipAt+(h?10:1)*c).toFixed(4))))});return[{keys:[" "],label:"space",what:"play, pause",act:()=>t.toggle()},{keys:["ArrowLeft"],label:"\u2190",what:"one frame back (shift: ten)",act:c=>t.step(c?-10:-1)},{keys:["ArrowRight"],label:"\u2192",what:"one frame forward (shift: ten)",act:c=>t.step(c?10:1)},{keys:["Home"],label:"Home",what:"first frame",act:()=>{t.go(0)}},{keys:["End"],label:"End",what:"last frame",act:()=>{t.go(t.moments.length-1)}},{keys:["g"],label:"g",what:"follow a run in progress",act:()=>this.follow()},{keys:["f"],label:"f",what:"all in view",act:()=>i.fit()},...["x","y","z"].map((c,h)=>({keys:[String(h+1)],label:String(h+1),what:`look along ${c} (in space)`,act:()=>i.fit(c)})),{keys:["e"],label:"e",what:"edges",act:()=>e.set({edges:!e.now.edges})},{keys:["y"],label:"y",what:"light and shadow (in space)",act:()=>e.set({shadows:!e.now.shadows})},{keys:["q"],label:"q",what:"colours: materials, displacement, velocity",act:a},{keys:["u"],label:"u",what:"supports",act:()=>e.set({supports:!e.now.supports})},{keys:["h"],label:"h",what:"boundaries: held, moved, viscous, loaded faces (in space)",act:()=>e.set({boundaries:!e.now.boundaries})},{keys:["l"],label:"l",what:"loads: arrows",act:()=>e.set({loads:!e.now.loads})},{keys:["w"],label:"w",what:"water table",act:()=>e.set({water:!e.now.water})},{keys:["j"],label:"j",what:"joints: by set, by interface, not",act:o},{keys:["c"],label:"c",what:"contacts",act:()=>e.set({contacts:!e.now.contacts})},{keys:["n"],label:"n",what:"force chains: tubes as thick as the contact force",act:()=>e.set({chains:!e.now.chains})},{keys:["k"],label:"k",what:"cracks (in space)",act:()=>e.set({cracks:!e.now.cracks})},{keys:["r"],label:"r",what:"bolts: rods, red in tension, blue in compression",act:()=>e.set({bolts:!e.now.bolts})},{keys:["i"],label:"i",what:"charges: stars where they are (in space)",act:()=>e.set({charges:!e.now.charges})},{keys:["a"],label:"a",what:"principal stresses as crosses",act:()=>e.set({stress:!e.now.stress})},{keys:["d"],label:"d",what:"distance, and the field along a line: click both ends (again: remove it)",act:()=>this.toggleLine()},{keys:["v"],label:"v",what:"velocity arrows",act:()=>e.set({vectors:e.now.vectors?"":"velocity"})},{keys:["x"],label:"x",what:"cut away: along x, y, z, any plane, nothing",act:r},{keys:["b"],label:"b",what:"cut flat, or whole blocks",act:()=>e.set({clipFlat:!e.now.clipFlat})},{keys:["o"],label:"o",what:"cut away the other side",act:()=>e.set({clipFlip:!e.now.clipFlip})},{keys:[",",";","<"],label:",",what:"cut back (shift: ten times as far)",act:l(-.01)},{keys:[".",":",">"],label:".",what:"cut forward (shift: ten times as far)",act:l(.01)},{keys:["["],label:"[",what:"less exaggeration",act:s(.5)},{keys:["]"],label:"]",what:"more exaggeration",act:s(2)},{keys:["p"],label:"p",what:"histories",act:()=>this.toggle("with-plots")},{keys:["m"],label:"m",what:"panel",act:()=>this.toggle("no-panel")},{keys:["s"],label:"s",what:"save a picture",act:()=>{this.save("picture")}},{keys:["t"],label:"t",what:"light, dark",act:()=>this.flipTheme()},{keys:["Escape"],label:"Esc",what:"deselect the block; no note after all",act:()=>{this.writing&&this.setMeasuring(!1),i.unpick()}},{keys:["?"],label:"?",what:"this sheet",act:()=>document.querySelector("dialog.sheet")?.showModal()}]}toggleLine(){let e=this.measuring||this.panes.some(({view:t})=>t.ends.length>0);this.layLine([]),this.setMeasuring(!e)}toggle(e){this.host.classList.toggle(e),this.openPlots()}follow(){this.timeline.following=!this.timeline.following,this.refreshHead(),this.timeline.following&&this.timeline.go(this.timeline.moments.length-1)}news(){setTimeout(async()=>{let e=this.panes.map(r=>r.view.run),t=await Promise.allSettled(e.map(r=>r.refresh()));if(t.some(r=>r.status==="fulfilled"&&r.value)){location.reload();return}let i=this.moments(e),s=i.length!==this.timeline.moments.length;this.timeline.setMoments(i),this.refreshHead();for(let r of this.panes)r.view.run.summary.manifest?.preview&&this.refreshPane(r);if(s){if(this.timeline.following)await this.timeline.go(i.length-1);else for(let r of this.panes)this.refreshPane(r);for(let r of this.panes)r.view.run.frames===0&&this.banner(r,M0(r.view.run))}s&&this.plots&&this.plots.tab!=="block"&&this.openPlots(),this.panes.forEach((r,a)=>this.answered(r,t[a])),e.some(r=>r.summary.live)?this.news():this.panel?.rebuild()},JL)}answered(e,t){t.status==="rejected"?(this.silent.add(e),this.banner(e,Lr(t.reason))):this.silent.delete(e)&&(e.view.run.frames===0?this.banner(e,M0(e.view.run)):this.refreshPane(e))}refreshHead(){let e=this.runs[0],{manifest:t,name:i}=e.summary,s=this.runs.map(l=>l.summary.manifest?.title||l.summary.name);this.title.textContent=[...new Set(s)].join(" | "),this.title.title=i,document.title=`${s[0]} \u2013 riprap`;let r=this.runs.some(l=>l.summary.live),a=this.runs.some(l=>l.summary.died),o=t?t.preview?"not run":r?"running":a?"unfinished":t.ended:"unreadable";this.badge.textContent=r&&this.timeline.following&&!t?.preview?"running, followed":o,this.badge.className=`badge ${o}`,this.badge.title=t?r?`step ${t.steps.toLocaleString("en")}; g follows the newest frame`:a?"The program that wrote this run has died. Its results so far are shown; riprap resume continues from the last checkpoint.":`${t.message||"all phases are complete"}; ${qt(t.wall_time,3)} s`:""}flipTheme(){fw(),this.themed()}themed(){let e=getComputedStyle(document.documentElement),t=e.getPropertyValue("--paper").trim(),i=e.getPropertyValue("--ink").trim();for(let{view:s}of this.panes)s.setTheme(t,i);this.plots?.retheme()}};function QL(n,e){return J("div.cardhost",{},J("div.card.problem",{role:"alert"},J("h2",{},`${n} cannot be shown`),J("p",{},e.what),J("p.hint",{},e.hint)))}function eD(n){let{preview:e,message:t}=n.summary.manifest??{};return e&&t?{what:"The scene as saved cannot be shown.",hint:t}:null}function M0(n){return n.summary.live?{what:"No frame yet.",hint:"The run has started; the first frame will be shown when it is written."}:{what:"This run has no frames.",hint:'Request them in the scene and run it again: [[outputs]] frames = { every = "10 ms" }. Its histories are available (p).'}}function tD(n){let{view:e}=n;if(!e.blocks)return;let t=e.stage.triad(),i=e.flat?["x","y"]:["x","y","z"],s=["#d9483b","#2f9e57","#3576d6"],r=i.map((h,u)=>{let[f,d]=[32+24*t[u][0],32-24*t[u][1]],[p,v]=[32+30*t[u][0],32-30*t[u][1]];return`<line x1="32" y1="32" x2="${f}" y2="${d}" stroke="${s[u]}"/><text x="${p}" y="${v}" fill="${s[u]}">${h}</text>`}),a=e.stage.metresPerPixel(),o=90*a,l=10**Math.floor(Math.log10(o)),c=([5,2,1].find(h=>h*l<=o)??1)*l;n.triad.innerHTML=`<svg viewBox="0 0 64 64" width="64" height="64">${r.join("")}</svg><span class="bar" style="width:${(c/a).toFixed(1)}px">${pn(c,"m",3)}</span>`}async function nD(){let n=document.getElementById("riprap-run");if(n?.textContent)return[new $f(new Map(Object.entries(JSON.parse(n.textContent))))];let e=await fetch("api/runs"),{runs:t}=await e.json();return Array.from({length:t},(i,s)=>new Xf(s,T0))}Xd();var E0=document.getElementById("app")??J("div"),T0=new Wf;E0.append(T0.object);try{await new $d(E0,T0).start(await nD())}catch(n){let{what:e,hint:t}=Lr(n);E0.replaceChildren(J("div.card.problem",{role:"alert"},J("h1",{},"The viewer cannot start"),J("p",{},e),J("p.hint",{},t)))}
