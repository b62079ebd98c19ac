var zy=Object.defineProperty;var Hy=(i,e)=>{for(var t in e)zy(i,t,{get:e[t],enumerable:!0})};function Q(i,e={},...t){let[n,...s]=i.split("."),r=document.createElement(n);s.length>0&&(r.className=s.join(" "));for(let[o,a]of Object.entries(e))o.startsWith("on")&&typeof a=="function"?r.addEventListener(o.slice(2),a):o in r&&!o.startsWith("aria")&&o!=="for"?r[o]=a:a!==void 0&&a!==!1&&r.setAttribute(o,String(a));return r.append(...t.filter(o=>o!=null)),r}function Vn(i,...e){return Q("label.row",{},Q("span.name",{},i),Q("span.controls",{},...e))}function Gn(i,e,t,n=""){let s=Q("input",{type:"checkbox",checked:e,onchange:()=>t(s.checked)});return Q("label.check",{title:n},s,Q("span",{},i))}function hi(i,e,t,n){let s=Q("select",{onchange:()=>t(s.value),"aria-label":n});for(let[r,o]of i)s.append(Q("option",{value:r},o));return s.value=e,s}function lr(i,e){let t=URL.createObjectURL(i),n=Q("a",{href:t,download:e});document.body.append(n),n.click(),n.remove(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}var Vy={play:"M7 4l13 8-13 8z",pause:"M6 4h4v16H6zM14 4h4v16h-4z",first:"M6 5h2v14H6zM20 5v14L9 12z",last:"M16 5h2v14h-2zM4 5v14l11-7z",back:"M17 5v14L7 12z",next:"M7 5v14l10-7z",fit:"M4 9V4h5v2H6v3zM15 4h5v5h-2V6h-3zM4 15h2v3h3v2H4zM18 15h2v5h-5v-2h3z",menu:"M4 6h16v2H4zM4 11h16v2H4zM4 16h16v2H4z",theme:"M12 3a9 9 0 1 0 9 9 7 7 0 0 1-9-9z",help:"M11 17h2v2h-2zM12 4a5 5 0 0 0-5 5h2a3 3 0 1 1 4.6 2.5C12.2 12.4 11 13.3 11 15h2c0-1 .7-1.500 1.700-2.200A5 5 0 0 0 12 4z",camera:"M9 5l-1.500 2H4v12h16V7h-3.500L15 5zM12 9.500a3.500 3.500 0 1 1 0 7 3.500 3.500 0 0 1 0-7z",plots:"M4 4h2v14h14v2H4zM8 15l4-6 3 3 4-7 1.600 1L15.500 15l-3-3L9.600 16z",loop:"M7 7h10v3l4-4-4-4v3H5v6h2zM17 17H7v-3l-4 4 4 4v-3h12v-6h-2z"};function Af(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Vy[i]??""),e.append(t),e}function Ui(i,e,t){return Q("button.icon",{title:e,"aria-label":e,onclick:t,type:"button"},Af(i))}var Vp={};Hy(Vp,{compose:()=>Bp,film:()=>W2,picture:()=>Hp,sequence:()=>B2});var Yn=Uint8Array,Mi=Uint16Array,Df=Int32Array,Nf=new Yn([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Uf=new Yn([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Wm=new Yn([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Jm=function(i,e){for(var t=new Mi(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var s=new Df(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)s[r]=r-t[n]<<5|n;return{b:t,r:s}},Km=Jm(Nf,2),Gy=Km.b,Cf=Km.r;Gy[28]=258,Cf[258]=28;var Qm=Jm(Uf,0),aC=Qm.b,Xm=Qm.r,Pf=new Mi(32768);for(At=0;At<32768;++At)Ls=(At&43690)>>1|(At&21845)<<1,Ls=(Ls&52428)>>2|(Ls&13107)<<2,Ls=(Ls&61680)>>4|(Ls&3855)<<4,Pf[At]=((Ls&65280)>>8|(Ls&255)<<8)>>1;var Ls,At,Sa=(function(i,e,t){for(var n=i.length,s=0,r=new Mi(e);s<n;++s)i[s]&&++r[i[s]-1];var o=new Mi(e);for(s=1;s<e;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(t){a=new Mi(1<<e);var l=15-e;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],h=e-i[s],u=o[i[s]-1]++<<h,f=u|(1<<h)-1;u<=f;++u)a[Pf[u]>>l]=c}else for(a=new Mi(n),s=0;s<n;++s)i[s]&&(a[s]=Pf[o[i[s]-1]++]>>15-i[s]);return a}),Ir=new Yn(288);for(At=0;At<144;++At)Ir[At]=8;var At;for(At=144;At<256;++At)Ir[At]=9;var At;for(At=256;At<280;++At)Ir[At]=7;var At;for(At=280;At<288;++At)Ir[At]=8;var At,$l=new Yn(32);for(At=0;At<32;++At)$l[At]=5;var At,Wy=Sa(Ir,9,0);var Xy=Sa($l,5,0);var eg=function(i){return(i+7)/8|0},tg=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new Yn(i.subarray(e,t))};var qy=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Yl=function(i,e,t){var n=new Error(e||qy[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Yl),!t)throw n;return n};var Ds=function(i,e,t){t<<=e&7;var n=e/8|0;i[n]|=t,i[n+1]|=t>>8},Ma=function(i,e,t){t<<=e&7;var n=e/8|0;i[n]|=t,i[n+1]|=t>>8,i[n+2]|=t>>16},Rf=function(i,e){for(var t=[],n=0;n<i.length;++n)i[n]&&t.push({s:n,f:i[n]});var s=t.length,r=t.slice();if(!s)return{t:ig,l:0};if(s==1){var o=new Yn(t[0].s+1);return o[t[0].s]=1,{t:o,l:1}}t.sort(function(R,S){return R.f-S.f}),t.push({s:-1,f:25001});var a=t[0],l=t[1],c=0,h=1,u=2;for(t[0]={s:-1,f:a.f+l.f,l:a,r:l};h!=s-1;)a=t[t[c].f<t[u].f?c++:u++],l=t[c!=h&&t[c].f<t[u].f?c++:u++],t[h++]={s:-1,f:a.f+l.f,l:a,r:l};for(var f=r[0].s,n=1;n<s;++n)r[n].s>f&&(f=r[n].s);var d=new Mi(f+1),p=If(t[h-1],d,0);if(p>e){var n=0,x=0,m=p-e,g=1<<m;for(r.sort(function(S,v){return d[v.s]-d[S.s]||S.f-v.f});n<s;++n){var b=r[n].s;if(d[b]>e)x+=g-(1<<p-d[b]),d[b]=e;else break}for(x>>=m;x>0;){var M=r[n].s;d[M]<e?x-=1<<e-d[M]++-1:++n}for(;n>=0&&x;--n){var y=r[n].s;d[y]==e&&(--d[y],++x)}p=e}return{t:new Yn(d),l:p}},If=function(i,e,t){return i.s==-1?Math.max(If(i.l,e,t+1),If(i.r,e,t+1)):e[i.s]=t},qm=function(i){for(var e=i.length;e&&!i[--e];);for(var t=new Mi(++e),n=0,s=i[0],r=1,o=function(l){t[n++]=l},a=1;a<=e;++a)if(i[a]==s&&a!=e)++r;else{if(!s&&r>2){for(;r>138;r-=138)o(32754);r>2&&(o(r>10?r-11<<5|28690:r-3<<5|12305),r=0)}else if(r>3){for(o(s),--r;r>6;r-=6)o(8304);r>2&&(o(r-3<<5|8208),r=0)}for(;r--;)o(s);r=1,s=i[a]}return{c:t.subarray(0,n),n:e}},wa=function(i,e){for(var t=0,n=0;n<e.length;++n)t+=i[n]*e[n];return t},ng=function(i,e,t){var n=t.length,s=eg(e+2);i[s]=n&255,i[s+1]=n>>8,i[s+2]=i[s]^255,i[s+3]=i[s+1]^255;for(var r=0;r<n;++r)i[s+r+4]=t[r];return(s+4+n)*8},$m=function(i,e,t,n,s,r,o,a,l,c,h){Ds(e,h++,t),++s[256];for(var u=Rf(s,15),f=u.t,d=u.l,p=Rf(r,15),x=p.t,m=p.l,g=qm(f),b=g.c,M=g.n,y=qm(x),R=y.c,S=y.n,v=new Mi(19),w=0;w<b.length;++w)++v[b[w]&31];for(var w=0;w<R.length;++w)++v[R[w]&31];for(var C=Rf(v,7),P=C.t,I=C.l,O=19;O>4&&!P[Wm[O-1]];--O);var z=c+5<<3,U=wa(s,Ir)+wa(r,$l)+o,G=wa(s,f)+wa(r,x)+o+14+3*O+wa(v,P)+2*v[16]+3*v[17]+7*v[18];if(l>=0&&z<=U&&z<=G)return ng(e,h,i.subarray(l,l+c));var q,H,ae,Y;if(Ds(e,h,1+(G<U)),h+=2,G<U){q=Sa(f,d,0),H=f,ae=Sa(x,m,0),Y=x;var ee=Sa(P,I,0);Ds(e,h,M-257),Ds(e,h+5,S-1),Ds(e,h+10,O-4),h+=14;for(var w=0;w<O;++w)Ds(e,h+3*w,P[Wm[w]]);h+=3*O;for(var te=[b,R],de=0;de<2;++de)for(var ce=te[de],w=0;w<ce.length;++w){var J=ce[w]&31;Ds(e,h,ee[J]),h+=P[J],J>15&&(Ds(e,h,ce[w]>>5&127),h+=ce[w]>>12)}}else q=Wy,H=Ir,ae=Xy,Y=$l;for(var w=0;w<a;++w){var ue=n[w];if(ue>255){var J=ue>>18&31;Ma(e,h,q[J+257]),h+=H[J+257],J>7&&(Ds(e,h,ue>>23&31),h+=Nf[J]);var ge=ue&31;Ma(e,h,ae[ge]),h+=Y[ge],ge>3&&(Ma(e,h,ue>>5&8191),h+=Uf[ge])}else Ma(e,h,q[ue]),h+=H[ue]}return Ma(e,h,q[256]),h+H[256]},$y=new Df([65540,131080,131088,131104,262176,1048704,1048832,2114560,2117632]),ig=new Yn(0),Yy=function(i,e,t,n,s,r){var o=r.z||i.length,a=new Yn(n+o+5*(1+Math.ceil(o/7e3))+s),l=a.subarray(n,a.length-s),c=r.l,h=(r.r||0)&7;if(e){h&&(l[0]=r.r>>3);for(var u=$y[e-1],f=u>>13,d=u&8191,p=(1<<t)-1,x=r.p||new Mi(32768),m=r.h||new Mi(p+1),g=Math.ceil(t/3),b=2*g,M=function(je){return(i[je]^i[je+1]<<g^i[je+2]<<b)&p},y=new Df(25e3),R=new Mi(288),S=new Mi(32),v=0,w=0,C=r.i||0,P=0,I=r.w||0,O=0;C+2<o;++C){var z=M(C),U=C&32767,G=m[z];if(x[U]=G,m[z]=U,I<=C){var q=o-C;if((v>7e3||P>24576)&&(q>423||!c)){h=$m(i,l,0,y,R,S,w,P,O,C-O,h),P=v=w=0,O=C;for(var H=0;H<286;++H)R[H]=0;for(var H=0;H<30;++H)S[H]=0}var ae=2,Y=0,ee=d,te=U-G&32767;if(q>2&&z==M(C-te))for(var de=Math.min(f,q)-1,ce=Math.min(32767,C),J=Math.min(258,q);te<=ce&&--ee&&U!=G;){if(i[C+ae]==i[C+ae-te]){for(var ue=0;ue<J&&i[C+ue]==i[C+ue-te];++ue);if(ue>ae){if(ae=ue,Y=te,ue>de)break;for(var ge=Math.min(te,ue-2),Se=0,H=0;H<ge;++H){var be=C-te+H&32767,Ge=x[be],tt=be-Ge&32767;tt>Se&&(Se=tt,G=be)}}}U=G,G=x[U],te+=U-G&32767}if(Y){y[P++]=268435456|Cf[ae]<<18|Xm[Y];var He=Cf[ae]&31,lt=Xm[Y]&31;w+=Nf[He]+Uf[lt],++R[257+He],++S[lt],I=C+ae,++v}else y[P++]=i[C],++R[i[C]]}}for(C=Math.max(C,I);C<o;++C)y[P++]=i[C],++R[i[C]];h=$m(i,l,c,y,R,S,w,P,O,C-O,h),c||(r.r=h&7|l[h/8|0]<<3,h-=7,r.h=m,r.p=x,r.i=C,r.w=I)}else{for(var C=r.w||0;C<o+c;C+=65535){var ot=C+65535;ot>=o&&(l[h/8|0]=c,ot=o),h=ng(l,h+1,i.subarray(C,ot))}r.i=o}return tg(a,0,n+eg(h)+s)},Zy=(function(){for(var i=new Int32Array(256),e=0;e<256;++e){for(var t=e,n=9;--n;)t=(t&1&&-306674912)^t>>>1;i[e]=t}return i})(),jy=function(){var i=-1;return{p:function(e){for(var t=i,n=0;n<e.length;++n)t=Zy[t&255^e[n]]^t>>>8;i=t},d:function(){return~i}}};var Jy=function(i,e,t,n,s){if(!s&&(s={l:1},e.dictionary)){var r=e.dictionary.subarray(-32768),o=new Yn(r.length+i.length);o.set(r),o.set(i,r.length),i=o,s.w=r.length}return Yy(i,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(i.length)))*1.5):20:12+e.mem,t,n,s)},sg=function(i,e){var t={};for(var n in i)t[n]=i[n];for(var n in e)t[n]=e[n];return t};var Wn=function(i,e,t){for(;t;++e)i[e]=t,t>>>=8};function Ky(i,e){return Jy(i,e||{},0,0)}var rg=function(i,e,t,n){for(var s in i){var r=i[s],o=e+s,a=n;Array.isArray(r)&&(a=sg(n,r[1]),r=r[0]),ArrayBuffer.isView(r)?t[o]=[r,a]:(t[o+="/"]=[new Yn(0),a],rg(r,o,t,n))}},Ym=typeof TextEncoder<"u"&&new TextEncoder,Qy=typeof TextDecoder<"u"&&new TextDecoder,e_=0;try{Qy.decode(ig,{stream:!0}),e_=1}catch{}function Zm(i,e){if(e){for(var t=new Yn(i.length),n=0;n<i.length;++n)t[n]=i.charCodeAt(n);return t}if(Ym)return Ym.encode(i);for(var s=i.length,r=new Yn(i.length+(i.length>>1)),o=0,a=function(h){r[o++]=h},n=0;n<s;++n){if(o+5>r.length){var l=new Yn(o+8+(s-n<<1));l.set(r),r=l}var c=i.charCodeAt(n);c<128||e?a(c):c<2048?(a(192|c>>6),a(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|i.charCodeAt(++n)&1023,a(240|c>>18),a(128|c>>12&63),a(128|c>>6&63),a(128|c&63)):(a(224|c>>12),a(128|c>>6&63),a(128|c&63))}return tg(r,0,o)}var Lf=function(i){var e=0;if(i)for(var t in i){var n=i[t].length;n>65535&&Yl(9),e+=n+4}return e},jm=function(i,e,t,n,s,r,o,a){var l=n.length,c=t.extra,h=a&&a.length,u=Lf(c);Wn(i,e,o!=null?33639248:67324752),e+=4,o!=null&&(i[e++]=20,i[e++]=t.os),i[e]=20,e+=2,i[e++]=t.flag<<1|(r<0&&8),i[e++]=s&&8,i[e++]=t.compression&255,i[e++]=t.compression>>8;var f=new Date(t.mtime==null?Date.now():t.mtime),d=f.getFullYear()-1980;if((d<0||d>119)&&Yl(10),Wn(i,e,d<<25|f.getMonth()+1<<21|f.getDate()<<16|f.getHours()<<11|f.getMinutes()<<5|f.getSeconds()>>1),e+=4,r!=-1&&(Wn(i,e,t.crc),Wn(i,e+4,r<0?-r-2:r),Wn(i,e+8,t.size)),Wn(i,e+12,l),Wn(i,e+14,u),e+=16,o!=null&&(Wn(i,e,h),Wn(i,e+6,t.attrs),Wn(i,e+10,o),e+=14),i.set(n,e),e+=l,u)for(var p in c){var x=c[p],m=x.length;Wn(i,e,+p),Wn(i,e+2,m),i.set(x,e+4),e+=4+m}return h&&(i.set(a,e),e+=h),e},t_=function(i,e,t,n,s){Wn(i,e,101010256),Wn(i,e+8,t),Wn(i,e+10,t),Wn(i,e+12,n),Wn(i,e+16,s)};function og(i,e){e||(e={});var t={},n=[];rg(i,"",t,e);var s=0,r=0;for(var o in t){var a=t[o],l=a[0],c=a[1],h=c.level==0?0:8,u=Zm(o),f=u.length,d=c.comment,p=d&&Zm(d),x=p&&p.length,m=Lf(c.extra);f>65535&&Yl(11);var g=h?Ky(l,c):l,b=g.length,M=jy();M.p(l),n.push(sg(c,{size:l.length,crc:M.d(),c:g,f:u,m:p,u:f!=o.length||p&&d.length!=x,o:s,compression:h})),s+=30+f+m+b,r+=76+2*(f+m)+(x||0)+b}for(var y=new Yn(r+22),R=s,S=r-s,v=0;v<n.length;++v){var u=n[v];jm(y,u.o,u,u.f,u.u,u.c.length);var w=30+u.f.length+Lf(u.extra);y.set(u.c,u.o+w),jm(y,s,u,u.f,u.u,u.c.length,u.o,u.m),s+=16+w+(u.m?u.m.length:0)}return t_(y,s,n.length,S,R),y}function xo(i,e,t){i.prototype=e.prototype=t,t.constructor=i}function Aa(i,e){var t=Object.create(i.prototype);for(var n in e)t[n]=e[n];return t}function cr(){}var Ur=.7,go=1/Ur,po="\\s*([+-]?\\d+)\\s*",Ea="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)\\s*",ps="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)%\\s*",n_=/^#([0-9a-f]{3,8})$/,i_=new RegExp(`^rgb\\(${po},${po},${po}\\)$`),s_=new RegExp(`^rgb\\(${ps},${ps},${ps}\\)$`),r_=new RegExp(`^rgba\\(${po},${po},${po},${Ea}\\)$`),o_=new RegExp(`^rgba\\(${ps},${ps},${ps},${Ea}\\)$`),a_=new RegExp(`^hsl\\(${Ea},${ps},${ps}\\)$`),l_=new RegExp(`^hsla\\(${Ea},${ps},${ps},${Ea}\\)$`),ag={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074};xo(cr,Ql,{copy(i){return Object.assign(new this.constructor,this,i)},displayable(){return this.rgb().displayable()},hex:lg,formatHex:lg,formatHex8:c_,formatHsl:h_,formatRgb:cg,toString:cg});function lg(){return this.rgb().formatHex()}function c_(){return this.rgb().formatHex8()}function h_(){return bg(this).formatHsl()}function cg(){return this.rgb().formatRgb()}function Ql(i){var e,t;return i=(i+"").trim().toLowerCase(),(e=n_.exec(i))?(t=e[1].length,e=parseInt(e[1],16),t===6?hg(e):t===3?new On(e>>8&15|e>>4&240,e>>4&15|e&240,(e&15)<<4|e&15,1):t===8?Zl(e>>24&255,e>>16&255,e>>8&255,(e&255)/255):t===4?Zl(e>>12&15|e>>8&240,e>>8&15|e>>4&240,e>>4&15|e&240,((e&15)<<4|e&15)/255):null):(e=i_.exec(i))?new On(e[1],e[2],e[3],1):(e=s_.exec(i))?new On(e[1]*255/100,e[2]*255/100,e[3]*255/100,1):(e=r_.exec(i))?Zl(e[1],e[2],e[3],e[4]):(e=o_.exec(i))?Zl(e[1]*255/100,e[2]*255/100,e[3]*255/100,e[4]):(e=a_.exec(i))?dg(e[1],e[2]/100,e[3]/100,1):(e=l_.exec(i))?dg(e[1],e[2]/100,e[3]/100,e[4]):ag.hasOwnProperty(i)?hg(ag[i]):i==="transparent"?new On(NaN,NaN,NaN,0):null}function hg(i){return new On(i>>16&255,i>>8&255,i&255,1)}function Zl(i,e,t,n){return n<=0&&(i=e=t=NaN),new On(i,e,t,n)}function Hf(i){return i instanceof cr||(i=Ql(i)),i?(i=i.rgb(),new On(i.r,i.g,i.b,i.opacity)):new On}function Fr(i,e,t,n){return arguments.length===1?Hf(i):new On(i,e,t,n??1)}function On(i,e,t,n){this.r=+i,this.g=+e,this.b=+t,this.opacity=+n}xo(On,Fr,Aa(cr,{brighter(i){return i=i==null?go:Math.pow(go,i),new On(this.r*i,this.g*i,this.b*i,this.opacity)},darker(i){return i=i==null?Ur:Math.pow(Ur,i),new On(this.r*i,this.g*i,this.b*i,this.opacity)},rgb(){return this},clamp(){return new On(Dr(this.r),Dr(this.g),Dr(this.b),Jl(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.b<255.5&&0<=this.opacity&&this.opacity<=1},hex:ug,formatHex:ug,formatHex8:u_,formatRgb:fg,toString:fg}));function ug(){return`#${Lr(this.r)}${Lr(this.g)}${Lr(this.b)}`}function u_(){return`#${Lr(this.r)}${Lr(this.g)}${Lr(this.b)}${Lr((isNaN(this.opacity)?1:this.opacity)*255)}`}function fg(){let i=Jl(this.opacity);return`${i===1?"rgb(":"rgba("}${Dr(this.r)}, ${Dr(this.g)}, ${Dr(this.b)}${i===1?")":`, ${i})`}`}function Jl(i){return isNaN(i)?1:Math.max(0,Math.min(1,i))}function Dr(i){return Math.max(0,Math.min(255,Math.round(i)||0))}function Lr(i){return i=Dr(i),(i<16?"0":"")+i.toString(16)}function dg(i,e,t,n){return n<=0?i=e=t=NaN:t<=0||t>=1?i=e=NaN:e<=0&&(i=NaN),new Zi(i,e,t,n)}function bg(i){if(i instanceof Zi)return new Zi(i.h,i.s,i.l,i.opacity);if(i instanceof cr||(i=Ql(i)),!i)return new Zi;if(i instanceof Zi)return i;i=i.rgb();var e=i.r/255,t=i.g/255,n=i.b/255,s=Math.min(e,t,n),r=Math.max(e,t,n),o=NaN,a=r-s,l=(r+s)/2;return a?(e===r?o=(t-n)/a+(t<n)*6:t===r?o=(n-e)/a+2:o=(e-t)/a+4,a/=l<.5?r+s:2-r-s,o*=60):a=l>0&&l<1?0:o,new Zi(o,a,l,i.opacity)}function ec(i,e,t,n){return arguments.length===1?bg(i):new Zi(i,e,t,n??1)}function Zi(i,e,t,n){this.h=+i,this.s=+e,this.l=+t,this.opacity=+n}xo(Zi,ec,Aa(cr,{brighter(i){return i=i==null?go:Math.pow(go,i),new Zi(this.h,this.s,this.l*i,this.opacity)},darker(i){return i=i==null?Ur:Math.pow(Ur,i),new Zi(this.h,this.s,this.l*i,this.opacity)},rgb(){var i=this.h%360+(this.h<0)*360,e=isNaN(i)||isNaN(this.s)?0:this.s,t=this.l,n=t+(t<.5?t:1-t)*e,s=2*t-n;return new On(Ff(i>=240?i-240:i+120,s,n),Ff(i,s,n),Ff(i<120?i+240:i-120,s,n),this.opacity)},clamp(){return new Zi(pg(this.h),jl(this.s),jl(this.l),Jl(this.opacity))},displayable(){return(0<=this.s&&this.s<=1||isNaN(this.s))&&0<=this.l&&this.l<=1&&0<=this.opacity&&this.opacity<=1},formatHsl(){let i=Jl(this.opacity);return`${i===1?"hsl(":"hsla("}${pg(this.h)}, ${jl(this.s)*100}%, ${jl(this.l)*100}%${i===1?")":`, ${i})`}`}}));function pg(i){return i=(i||0)%360,i<0?i+360:i}function jl(i){return Math.max(0,Math.min(1,i||0))}function Ff(i,e,t){return(i<60?e+(t-e)*i/60:i<180?t:i<240?e+(t-e)*(240-i)/60:e)*255}var vg=Math.PI/180,yg=180/Math.PI,Kl=18,_g=.96422,Mg=1,wg=.82521,Sg=4/29,mo=6/29,Eg=3*mo*mo,f_=mo*mo*mo;function Tg(i){if(i instanceof ms)return new ms(i.l,i.a,i.b,i.opacity);if(i instanceof Ns)return Rg(i);i instanceof On||(i=Hf(i));var e=zf(i.r),t=zf(i.g),n=zf(i.b),s=Of((.2225045*e+.7168786*t+.0606169*n)/Mg),r,o;return e===t&&t===n?r=o=s:(r=Of((.4360747*e+.3850649*t+.1430804*n)/_g),o=Of((.0139322*e+.0971045*t+.7141733*n)/wg)),new ms(116*s-16,500*(r-s),200*(s-o),i.opacity)}function Ag(i,e,t,n){return arguments.length===1?Tg(i):new ms(i,e,t,n??1)}function ms(i,e,t,n){this.l=+i,this.a=+e,this.b=+t,this.opacity=+n}xo(ms,Ag,Aa(cr,{brighter(i){return new ms(this.l+Kl*(i??1),this.a,this.b,this.opacity)},darker(i){return new ms(this.l-Kl*(i??1),this.a,this.b,this.opacity)},rgb(){var i=(this.l+16)/116,e=isNaN(this.a)?i:i+this.a/500,t=isNaN(this.b)?i:i-this.b/200;return e=_g*kf(e),i=Mg*kf(i),t=wg*kf(t),new On(Bf(3.1338561*e-1.6168667*i-.4906146*t),Bf(-.9787684*e+1.9161415*i+.033454*t),Bf(.0719453*e-.2289914*i+1.4052427*t),this.opacity)}}));function Of(i){return i>f_?Math.pow(i,1/3):i/Eg+Sg}function kf(i){return i>mo?i*i*i:Eg*(i-Sg)}function Bf(i){return 255*(i<=.0031308?12.92*i:1.055*Math.pow(i,1/2.4)-.055)}function zf(i){return(i/=255)<=.04045?i/12.92:Math.pow((i+.055)/1.055,2.4)}function d_(i){if(i instanceof Ns)return new Ns(i.h,i.c,i.l,i.opacity);if(i instanceof ms||(i=Tg(i)),i.a===0&&i.b===0)return new Ns(NaN,0<i.l&&i.l<100?0:NaN,i.l,i.opacity);var e=Math.atan2(i.b,i.a)*yg;return new Ns(e<0?e+360:e,Math.sqrt(i.a*i.a+i.b*i.b),i.l,i.opacity)}function tc(i,e,t,n){return arguments.length===1?d_(i):new Ns(i,e,t,n??1)}function Ns(i,e,t,n){this.h=+i,this.c=+e,this.l=+t,this.opacity=+n}function Rg(i){if(isNaN(i.h))return new ms(i.l,0,0,i.opacity);var e=i.h*vg;return new ms(i.l,Math.cos(e)*i.c,Math.sin(e)*i.c,i.opacity)}xo(Ns,tc,Aa(cr,{brighter(i){return new Ns(this.h,this.c,this.l+Kl*(i??1),this.opacity)},darker(i){return new Ns(this.h,this.c,this.l-Kl*(i??1),this.opacity)},rgb(){return Rg(this).rgb()}}));var Cg=-.14861,Vf=1.78277,Gf=-.29227,nc=-.90649,Ta=1.97294,mg=Ta*nc,gg=Ta*Vf,xg=Vf*Gf-nc*Cg;function p_(i){if(i instanceof Nr)return new Nr(i.h,i.s,i.l,i.opacity);i instanceof On||(i=Hf(i));var e=i.r/255,t=i.g/255,n=i.b/255,s=(xg*n+mg*e-gg*t)/(xg+mg-gg),r=n-s,o=(Ta*(t-s)-Gf*r)/nc,a=Math.sqrt(o*o+r*r)/(Ta*s*(1-s)),l=a?Math.atan2(o,r)*yg-120:NaN;return new Nr(l<0?l+360:l,a,s,i.opacity)}function Fi(i,e,t,n){return arguments.length===1?p_(i):new Nr(i,e,t,n??1)}function Nr(i,e,t,n){this.h=+i,this.s=+e,this.l=+t,this.opacity=+n}xo(Nr,Fi,Aa(cr,{brighter(i){return i=i==null?go:Math.pow(go,i),new Nr(this.h,this.s,this.l*i,this.opacity)},darker(i){return i=i==null?Ur:Math.pow(Ur,i),new Nr(this.h,this.s,this.l*i,this.opacity)},rgb(){var i=isNaN(this.h)?0:(this.h+120)*vg,e=+this.l,t=isNaN(this.s)?0:this.s*e*(1-e),n=Math.cos(i),s=Math.sin(i);return new On(255*(e+t*(Cg*n+Vf*s)),255*(e+t*(Gf*n+nc*s)),255*(e+t*(Ta*n)),this.opacity)}}));function Lg(i,e,t,n,s){var r=i*i,o=r*i;return((1-3*i+3*r-o)*e+(4-6*r+3*o)*t+(1+3*i+3*r-3*o)*n+o*s)/6}function m_(i){var e=i.length-1;return function(t){var n=t<=0?t=0:t>=1?(t=1,e-1):Math.floor(t*e),s=i[n],r=i[n+1],o=n>0?i[n-1]:2*s-r,a=n<e-1?i[n+2]:2*r-s;return Lg((t-n/e)*e,o,s,r,a)}}function g_(i){var e=i.length;return function(t){var n=Math.floor(((t%=1)<0?++t:t)*e),s=i[(n+e-1)%e],r=i[n%e],o=i[(n+1)%e],a=i[(n+2)%e];return Lg((t-n/e)*e,s,r,o,a)}}var Xf=i=>()=>i;function Dg(i,e){return function(t){return i+t*e}}function x_(i,e,t){return i=Math.pow(i,t),e=Math.pow(e,t)-i,t=1/t,function(n){return Math.pow(i+n*e,t)}}function qf(i,e){var t=e-i;return t?Dg(i,t>180||t<-180?t-360*Math.round(t/360):t):Xf(isNaN(i)?e:i)}function b_(i){return(i=+i)==1?ui:function(e,t){return t-e?x_(e,t,i):Xf(isNaN(e)?t:e)}}function ui(i,e){var t=e-i;return t?Dg(i,t):Xf(isNaN(i)?e:i)}var uC=(function i(e){var t=b_(e);function n(s,r){var o=t((s=Fr(s)).r,(r=Fr(r)).r),a=t(s.g,r.g),l=t(s.b,r.b),c=ui(s.opacity,r.opacity);return function(h){return s.r=o(h),s.g=a(h),s.b=l(h),s.opacity=c(h),s+""}}return n.gamma=i,n})(1);function Ng(i){return function(e){var t=e.length,n=new Array(t),s=new Array(t),r=new Array(t),o,a;for(o=0;o<t;++o)a=Fr(e[o]),n[o]=a.r||0,s[o]=a.g||0,r[o]=a.b||0;return n=i(n),s=i(s),r=i(r),a.opacity=1,function(l){return a.r=n(l),a.g=s(l),a.b=r(l),a+""}}}var Ug=Ng(m_),fC=Ng(g_);function bo(i,e){return i=+i,e=+e,function(t){return i*(1-t)+e*t}}var v_=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,dC=new RegExp(v_.source,"g");var Pg=180/Math.PI,Wf={translateX:0,translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function Fg(i,e,t,n,s,r){var o,a,l;return(o=Math.sqrt(i*i+e*e))&&(i/=o,e/=o),(l=i*t+e*n)&&(t-=i*l,n-=e*l),(a=Math.sqrt(t*t+n*n))&&(t/=a,n/=a,l/=a),i*n<e*t&&(i=-i,e=-e,l=-l,o=-o),{translateX:s,translateY:r,rotate:Math.atan2(e,i)*Pg,skewX:Math.atan(l)*Pg,scaleX:o,scaleY:a}}var ic;function y_(i){let e=new(typeof DOMMatrix=="function"?DOMMatrix:WebKitCSSMatrix)(i+"");return e.isIdentity?Wf:Fg(e.a,e.b,e.c,e.d,e.e,e.f)}function __(i){return i==null||(ic||(ic=document.createElementNS("http://www.w3.org/2000/svg","g")),ic.setAttribute("transform",i),!(i=ic.transform.baseVal.consolidate()))?Wf:(i=i.matrix,Fg(i.a,i.b,i.c,i.d,i.e,i.f))}function Og(i,e,t,n){function s(c){return c.length?c.pop()+" ":""}function r(c,h,u,f,d,p){if(c!==u||h!==f){var x=d.push("translate(",null,e,null,t);p.push({i:x-4,x:bo(c,u)},{i:x-2,x:bo(h,f)})}else(u||f)&&d.push("translate("+u+e+f+t)}function o(c,h,u,f){c!==h?(c-h>180?h+=360:h-c>180&&(c+=360),f.push({i:u.push(s(u)+"rotate(",null,n)-2,x:bo(c,h)})):h&&u.push(s(u)+"rotate("+h+n)}function a(c,h,u,f){c!==h?f.push({i:u.push(s(u)+"skewX(",null,n)-2,x:bo(c,h)}):h&&u.push(s(u)+"skewX("+h+n)}function l(c,h,u,f,d,p){if(c!==u||h!==f){var x=d.push(s(d)+"scale(",null,",",null,")");p.push({i:x-4,x:bo(c,u)},{i:x-2,x:bo(h,f)})}else(u!==1||f!==1)&&d.push(s(d)+"scale("+u+","+f+")")}return function(c,h){var u=[],f=[];return c=i(c),h=i(h),r(c.translateX,c.translateY,h.translateX,h.translateY,u,f),o(c.rotate,h.rotate,u,f),a(c.skewX,h.skewX,u,f),l(c.scaleX,c.scaleY,h.scaleX,h.scaleY,u,f),c=h=null,function(d){for(var p=-1,x=f.length,m;++p<x;)u[(m=f[p]).i]=m.x(d);return u.join("")}}}var pC=Og(y_,"px, ","px)","deg)"),mC=Og(__,", ",")",")"),M_=1e-12;function Ig(i){return((i=Math.exp(i))+1/i)/2}function w_(i){return((i=Math.exp(i))-1/i)/2}function S_(i){return((i=Math.exp(2*i))-1)/(i+1)}var gC=(function i(e,t,n){function s(r,o){var a=r[0],l=r[1],c=r[2],h=o[0],u=o[1],f=o[2],d=h-a,p=u-l,x=d*d+p*p,m,g;if(x<M_)g=Math.log(f/c)/e,m=function(v){return[a+v*d,l+v*p,c*Math.exp(e*v*g)]};else{var b=Math.sqrt(x),M=(f*f-c*c+n*x)/(2*c*t*b),y=(f*f-c*c-n*x)/(2*f*t*b),R=Math.log(Math.sqrt(M*M+1)-M),S=Math.log(Math.sqrt(y*y+1)-y);g=(S-R)/e,m=function(v){var w=v*g,C=Ig(R),P=c/(t*b)*(C*S_(e*w+R)-w_(R));return[a+P*d,l+P*p,c*C/Ig(e*w+R)]}}return m.duration=Math.abs(g)*1e3*e/Math.SQRT2,m}return s.rho=function(r){var o=Math.max(.001,+r),a=o*o,l=a*a;return i(o,a,l)},s})(Math.SQRT2,2,4);function kg(i){return function(e,t){var n=i((e=ec(e)).h,(t=ec(t)).h),s=ui(e.s,t.s),r=ui(e.l,t.l),o=ui(e.opacity,t.opacity);return function(a){return e.h=n(a),e.s=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var xC=kg(qf),bC=kg(ui);function Bg(i){return function(e,t){var n=i((e=tc(e)).h,(t=tc(t)).h),s=ui(e.c,t.c),r=ui(e.l,t.l),o=ui(e.opacity,t.opacity);return function(a){return e.h=n(a),e.c=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var vC=Bg(qf),yC=Bg(ui);function zg(i){return(function e(t){t=+t;function n(s,r){var o=i((s=Fi(s)).h,(r=Fi(r)).h),a=ui(s.s,r.s),l=ui(s.l,r.l),c=ui(s.opacity,r.opacity);return function(h){return s.h=o(h),s.s=a(h),s.l=l(Math.pow(h,t)),s.opacity=c(h),s+""}}return n.gamma=e,n})(1)}var _C=zg(qf),sc=zg(ui);function ht(i){for(var e=i.length/6|0,t=new Array(e),n=0;n<e;)t[n]="#"+i.slice(n*6,++n*6);return t}var EC=ht("1f77b4ff7f0e2ca02cd627289467bd8c564be377c27f7f7fbcbd2217becf"),TC=ht("7fc97fbeaed4fdc086ffff99386cb0f0027fbf5b17666666"),AC=ht("1b9e77d95f027570b3e7298a66a61ee6ab02a6761d666666"),RC=ht("4269d0efb118ff725c6cc5b03ca951ff8ab7a463f297bbf59c6b4e9498a0"),CC=ht("a6cee31f78b4b2df8a33a02cfb9a99e31a1cfdbf6fff7f00cab2d66a3d9affff99b15928"),PC=ht("fbb4aeb3cde3ccebc5decbe4fed9a6ffffcce5d8bdfddaecf2f2f2"),IC=ht("b3e2cdfdcdaccbd5e8f4cae4e6f5c9fff2aef1e2cccccccc"),LC=ht("e41a1c377eb84daf4a984ea3ff7f00ffff33a65628f781bf999999"),DC=ht("66c2a5fc8d628da0cbe78ac3a6d854ffd92fe5c494b3b3b3"),NC=ht("8dd3c7ffffb3bebadafb807280b1d3fdb462b3de69fccde5d9d9d9bc80bdccebc5ffed6f"),Hg=ht("4e79a7f28e2ce1575976b7b259a14fedc949af7aa1ff9da79c755fbab0ab"),zt=i=>Ug(i[i.length-1]),E_=new Array(3).concat("d8b365f5f5f55ab4ac","a6611adfc27d80cdc1018571","a6611adfc27df5f5f580cdc1018571","8c510ad8b365f6e8c3c7eae55ab4ac01665e","8c510ad8b365f6e8c3f5f5f5c7eae55ab4ac01665e","8c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e","8c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e","5430058c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e003c30","5430058c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e003c30").map(ht),UC=zt(E_),T_=new Array(3).concat("af8dc3f7f7f77fbf7b","7b3294c2a5cfa6dba0008837","7b3294c2a5cff7f7f7a6dba0008837","762a83af8dc3e7d4e8d9f0d37fbf7b1b7837","762a83af8dc3e7d4e8f7f7f7d9f0d37fbf7b1b7837","762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b7837","762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b7837","40004b762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b783700441b","40004b762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b783700441b").map(ht),FC=zt(T_),A_=new Array(3).concat("e9a3c9f7f7f7a1d76a","d01c8bf1b6dab8e1864dac26","d01c8bf1b6daf7f7f7b8e1864dac26","c51b7de9a3c9fde0efe6f5d0a1d76a4d9221","c51b7de9a3c9fde0eff7f7f7e6f5d0a1d76a4d9221","c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221","c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221","8e0152c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221276419","8e0152c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221276419").map(ht),OC=zt(A_),R_=new Array(3).concat("998ec3f7f7f7f1a340","5e3c99b2abd2fdb863e66101","5e3c99b2abd2f7f7f7fdb863e66101","542788998ec3d8daebfee0b6f1a340b35806","542788998ec3d8daebf7f7f7fee0b6f1a340b35806","5427888073acb2abd2d8daebfee0b6fdb863e08214b35806","5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b35806","2d004b5427888073acb2abd2d8daebfee0b6fdb863e08214b358067f3b08","2d004b5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b358067f3b08").map(ht),kC=zt(R_),C_=new Array(3).concat("ef8a62f7f7f767a9cf","ca0020f4a58292c5de0571b0","ca0020f4a582f7f7f792c5de0571b0","b2182bef8a62fddbc7d1e5f067a9cf2166ac","b2182bef8a62fddbc7f7f7f7d1e5f067a9cf2166ac","b2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac","b2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac","67001fb2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac053061","67001fb2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac053061").map(ht),Vg=zt(C_),P_=new Array(3).concat("ef8a62ffffff999999","ca0020f4a582bababa404040","ca0020f4a582ffffffbababa404040","b2182bef8a62fddbc7e0e0e09999994d4d4d","b2182bef8a62fddbc7ffffffe0e0e09999994d4d4d","b2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d","b2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d","67001fb2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d1a1a1a","67001fb2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d1a1a1a").map(ht),BC=zt(P_),I_=new Array(3).concat("fc8d59ffffbf91bfdb","d7191cfdae61abd9e92c7bb6","d7191cfdae61ffffbfabd9e92c7bb6","d73027fc8d59fee090e0f3f891bfdb4575b4","d73027fc8d59fee090ffffbfe0f3f891bfdb4575b4","d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4","d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4","a50026d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4313695","a50026d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4313695").map(ht),zC=zt(I_),L_=new Array(3).concat("fc8d59ffffbf91cf60","d7191cfdae61a6d96a1a9641","d7191cfdae61ffffbfa6d96a1a9641","d73027fc8d59fee08bd9ef8b91cf601a9850","d73027fc8d59fee08bffffbfd9ef8b91cf601a9850","d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850","d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850","a50026d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850006837","a50026d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850006837").map(ht),HC=zt(L_),D_=new Array(3).concat("fc8d59ffffbf99d594","d7191cfdae61abdda42b83ba","d7191cfdae61ffffbfabdda42b83ba","d53e4ffc8d59fee08be6f59899d5943288bd","d53e4ffc8d59fee08bffffbfe6f59899d5943288bd","d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd","d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd","9e0142d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd5e4fa2","9e0142d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd5e4fa2").map(ht),VC=zt(D_),N_=new Array(3).concat("e5f5f999d8c92ca25f","edf8fbb2e2e266c2a4238b45","edf8fbb2e2e266c2a42ca25f006d2c","edf8fbccece699d8c966c2a42ca25f006d2c","edf8fbccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45006d2c00441b").map(ht),GC=zt(N_),U_=new Array(3).concat("e0ecf49ebcda8856a7","edf8fbb3cde38c96c688419d","edf8fbb3cde38c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d810f7c4d004b").map(ht),WC=zt(U_),F_=new Array(3).concat("e0f3dba8ddb543a2ca","f0f9e8bae4bc7bccc42b8cbe","f0f9e8bae4bc7bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe0868ac084081").map(ht),XC=zt(F_),O_=new Array(3).concat("fee8c8fdbb84e34a33","fef0d9fdcc8afc8d59d7301f","fef0d9fdcc8afc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301fb300007f0000").map(ht),qC=zt(O_),k_=new Array(3).concat("ece2f0a6bddb1c9099","f6eff7bdc9e167a9cf02818a","f6eff7bdc9e167a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016c59014636").map(ht),$C=zt(k_),B_=new Array(3).concat("ece7f2a6bddb2b8cbe","f1eef6bdc9e174a9cf0570b0","f1eef6bdc9e174a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0045a8d023858").map(ht),YC=zt(B_),z_=new Array(3).concat("e7e1efc994c7dd1c77","f1eef6d7b5d8df65b0ce1256","f1eef6d7b5d8df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125698004367001f").map(ht),ZC=zt(z_),H_=new Array(3).concat("fde0ddfa9fb5c51b8a","feebe2fbb4b9f768a1ae017e","feebe2fbb4b9f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a017749006a").map(ht),jC=zt(H_),V_=new Array(3).concat("edf8b17fcdbb2c7fb8","ffffcca1dab441b6c4225ea8","ffffcca1dab441b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea8253494081d58").map(ht),$f=zt(V_),G_=new Array(3).concat("f7fcb9addd8e31a354","ffffccc2e69978c679238443","ffffccc2e69978c67931a354006837","ffffccd9f0a3addd8e78c67931a354006837","ffffccd9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443006837004529").map(ht),JC=zt(G_),W_=new Array(3).concat("fff7bcfec44fd95f0e","ffffd4fed98efe9929cc4c02","ffffd4fed98efe9929d95f0e993404","ffffd4fee391fec44ffe9929d95f0e993404","ffffd4fee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c02993404662506").map(ht),KC=zt(W_),X_=new Array(3).concat("ffeda0feb24cf03b20","ffffb2fecc5cfd8d3ce31a1c","ffffb2fecc5cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cbd0026800026").map(ht),QC=zt(X_),q_=new Array(3).concat("deebf79ecae13182bd","eff3ffbdd7e76baed62171b5","eff3ffbdd7e76baed63182bd08519c","eff3ffc6dbef9ecae16baed63182bd08519c","eff3ffc6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b508519c08306b").map(ht),eP=zt(q_),$_=new Array(3).concat("e5f5e0a1d99b31a354","edf8e9bae4b374c476238b45","edf8e9bae4b374c47631a354006d2c","edf8e9c7e9c0a1d99b74c47631a354006d2c","edf8e9c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45006d2c00441b").map(ht),tP=zt($_),Y_=new Array(3).concat("f0f0f0bdbdbd636363","f7f7f7cccccc969696525252","f7f7f7cccccc969696636363252525","f7f7f7d9d9d9bdbdbd969696636363252525","f7f7f7d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525000000").map(ht),nP=zt(Y_),Z_=new Array(3).concat("efedf5bcbddc756bb1","f2f0f7cbc9e29e9ac86a51a3","f2f0f7cbc9e29e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a354278f3f007d").map(ht),iP=zt(Z_),j_=new Array(3).concat("fee0d2fc9272de2d26","fee5d9fcae91fb6a4acb181d","fee5d9fcae91fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181da50f1567000d").map(ht),sP=zt(j_),J_=new Array(3).concat("fee6cefdae6be6550d","feeddefdbe85fd8d3cd94701","feeddefdbe85fd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d94801a636037f2704").map(ht),rP=zt(J_);function Gg(i){return i=Math.max(0,Math.min(1,i)),"rgb("+Math.max(0,Math.min(255,Math.round(-4.54-i*(35.34-i*(2381.73-i*(6402.7-i*(7024.72-i*2710.57)))))))+", "+Math.max(0,Math.min(255,Math.round(32.49+i*(170.73+i*(52.82-i*(131.46-i*(176.58-i*67.37)))))))+", "+Math.max(0,Math.min(255,Math.round(81.24+i*(442.36-i*(2482.43-i*(6167.24-i*(6614.94-i*2475.67)))))))+")"}var oP=sc(Fi(300,.5,0),Fi(-240,.5,1)),aP=sc(Fi(-100,.75,.35),Fi(80,1.5,.8)),lP=sc(Fi(260,.75,.35),Fi(80,1.5,.8)),cP=Fi();var hP=Fr(),uP=Math.PI/3,fP=Math.PI*2/3;function Wg(i){return i=Math.max(0,Math.min(1,i)),"rgb("+Math.max(0,Math.min(255,Math.round(34.61+i*(1172.33-i*(10793.56-i*(33300.12-i*(38394.49-i*14825.05)))))))+", "+Math.max(0,Math.min(255,Math.round(23.31+i*(557.33+i*(1225.33-i*(3574.96-i*(1073.77+i*707.56)))))))+", "+Math.max(0,Math.min(255,Math.round(27.2+i*(3211.1-i*(15327.97-i*(27814-i*(22569.18-i*6838.66)))))))+")"}function rc(i){var e=i.length;return function(t){return i[Math.max(0,Math.min(e-1,Math.floor(t*e)))]}}var Xg=rc(ht("44015444025645045745055946075a46085c460a5d460b5e470d60470e6147106347116447136548146748166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde725")),qg=rc(ht("00000401000501010601010802010902020b02020d03030f03031204041405041606051806051a07061c08071e0907200a08220b09240c09260d0a290e0b2b100b2d110c2f120d31130d34140e36150e38160f3b180f3d19103f1a10421c10441d11471e114920114b21114e22115024125325125527125829115a2a115c2c115f2d11612f116331116533106734106936106b38106c390f6e3b0f703d0f713f0f72400f74420f75440f764510774710784910784a10794c117a4e117b4f127b51127c52137c54137d56147d57157e59157e5a167e5c167f5d177f5f187f601880621980641a80651a80671b80681c816a1c816b1d816d1d816e1e81701f81721f817320817521817621817822817922827b23827c23827e24828025828125818326818426818627818827818928818b29818c29818e2a81902a81912b81932b80942c80962c80982d80992d809b2e7f9c2e7f9e2f7fa02f7fa1307ea3307ea5317ea6317da8327daa337dab337cad347cae347bb0357bb2357bb3367ab5367ab73779b83779ba3878bc3978bd3977bf3a77c03a76c23b75c43c75c53c74c73d73c83e73ca3e72cc3f71cd4071cf4070d0416fd2426fd3436ed5446dd6456cd8456cd9466bdb476adc4869de4968df4a68e04c67e24d66e34e65e44f64e55064e75263e85362e95462ea5661eb5760ec5860ed5a5fee5b5eef5d5ef05f5ef1605df2625df2645cf3655cf4675cf4695cf56b5cf66c5cf66e5cf7705cf7725cf8745cf8765cf9785df9795df97b5dfa7d5efa7f5efa815ffb835ffb8560fb8761fc8961fc8a62fc8c63fc8e64fc9065fd9266fd9467fd9668fd9869fd9a6afd9b6bfe9d6cfe9f6dfea16efea36ffea571fea772fea973feaa74feac76feae77feb078feb27afeb47bfeb67cfeb77efeb97ffebb81febd82febf84fec185fec287fec488fec68afec88cfeca8dfecc8ffecd90fecf92fed194fed395fed597fed799fed89afdda9cfddc9efddea0fde0a1fde2a3fde3a5fde5a7fde7a9fde9aafdebacfcecaefceeb0fcf0b2fcf2b4fcf4b6fcf6b8fcf7b9fcf9bbfcfbbdfcfdbf")),dP=rc(ht("00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c431e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f3609613809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f24699025689225689326679526679727669827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305cb0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4ec63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3ed94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602de9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1fcffa4")),pP=rc(ht("0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e05952f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a66100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a87801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba58e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9ba21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8eb42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72d24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844bf3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983ef99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724f0f921"));/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Vi={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ts={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},N0=0,Pd=1,U0=2;var bl=1,F0=2,$o=3,Ms=0,li=1,rn=2,Zs=0,Yo=1,Id=2,Ld=3,Dd=4,O0=5;var Gr=100,k0=101,B0=102,z0=103,H0=104,V0=200,G0=201,W0=202,X0=203,Nd=204,Ud=205,q0=206,$0=207,Y0=208,Z0=209,j0=210,J0=211,K0=212,Q0=213,ex=214,Uc=0,Fc=1,Oc=2,No=3,kc=4,Bc=5,zc=6,Hc=7,bh=0,tx=1,nx=2,ws=0,Fd=1,Od=2,kd=3,Bd=4,zd=5,Hd=6,Vd=7;var Gd=300,Wr=301,Zo=302,vh=303,yh=304,Vc=1e3,xs=1001,Gc=1002,Wt=1003,ix=1004;var vl=1005;var ai=1006,_h=1007;var js=1008;var di=1009,Wd=1010,Xd=1011,jo=1012,Mh=1013,Ci=1014,Gi=1015,ns=1016,wh=1017,Sh=1018,Xr=1020,qd=35902,$d=35899,Yd=1021,Zd=1022,is=1023,Hs=1026,Js=1027,Eh=1028,Th=1029,_r=1030,Ah=1031;var Rh=1033,yl=33776,_l=33777,Ml=33778,wl=33779,Ch=35840,Ph=35841,Ih=35842,Lh=35843,Dh=36196,Nh=37492,Uh=37496,Fh=37488,Oh=37489,Sl=37490,kh=37491,Bh=37808,zh=37809,Hh=37810,Vh=37811,Gh=37812,Wh=37813,Xh=37814,qh=37815,$h=37816,Yh=37817,Zh=37818,jh=37819,Jh=37820,Kh=37821,Qh=36492,eu=36494,tu=36495,nu=36283,iu=36284,El=36285,su=36286;var Ha=2300,Wc=2301,Dc=2302,bd=2303,vd=2400,yd=2401,_d=2402;var sx=3200;var ru=0,rx=1,Ks="",ri="srgb",Va="srgb-linear",Ga="linear",Pt="srgb";var Nc=7680;var ox=519,ax=512,lx=513,cx=514,jd=515,hx=516,ux=517,Jd=518,Kd=519,fx=35044,Tl=35048;var Qd="300 es",ki=2e3,Uo=2001;function K_(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Q_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Wa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function dx(){let i=Wa("canvas");return i.style.display="block",i}var $g={},Fo=null;function ep(...i){let e="THREE."+i.shift();Fo?Fo("log",e,...i):console.log(e,...i)}function px(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ye(...i){i=px(i);let e="THREE."+i.shift();if(Fo)Fo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function et(...i){i=px(i);let e="THREE."+i.shift();if(Fo)Fo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Fa(...i){let e=i.join(" ");e in $g||($g[e]=!0,Ye(...i))}function mx(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var gx={[Uc]:Uc,[Oc]:zc,[kc]:kc,[No]:Bc,[Fc]:Fc,[zc]:Oc,[Hc]:Hc,[Bc]:No},Qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Yg=1234567,Oa=Math.PI/180,Oo=180/Math.PI;function qr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Zn[i&255]+Zn[i>>8&255]+Zn[i>>16&255]+Zn[i>>24&255]+"-"+Zn[e&255]+Zn[e>>8&255]+"-"+Zn[e>>16&15|64]+Zn[e>>24&255]+"-"+Zn[t&63|128]+Zn[t>>8&255]+"-"+Zn[t>>16&255]+Zn[t>>24&255]+Zn[n&255]+Zn[n>>8&255]+Zn[n>>16&255]+Zn[n>>24&255]).toLowerCase()}function ft(i,e,t){return Math.max(e,Math.min(t,i))}function tp(i,e){return(i%e+e)%e}function e1(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function t1(i,e,t){return i!==e?(t-i)/(e-i):0}function ka(i,e,t){return(1-t)*i+t*e}function n1(i,e,t,n){return ka(i,e,1-Math.exp(-t*n))}function i1(i,e=1){return e-Math.abs(tp(i,e*2)-e)}function s1(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function r1(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function o1(i,e){return i+Math.floor(Math.random()*(e-i+1))}function a1(i,e){return i+Math.random()*(e-i)}function l1(i){return i*(.5-Math.random())}function c1(i){i!==void 0&&(Yg=i);let e=Yg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function h1(i){return i*Oa}function u1(i){return i*Oo}function f1(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function d1(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function np(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function p1(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),f=o((e-n)/2),d=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*d,a*c);break;case"YXY":i.set(l*d,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*d,a*h,a*c);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ip(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function xx(i,e){if(e.constructor===Float32Array)return i;let t=ip(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function bx(i,e){if(e.constructor===Float32Array)return i;let t=ip(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Jn={DEG2RAD:Oa,RAD2DEG:Oo,generateUUID:qr,clamp:ft,euclideanModulo:tp,mapLinear:e1,inverseLerp:t1,lerp:ka,damp:n1,pingpong:i1,smoothstep:s1,smootherstep:r1,randInt:o1,randFloat:a1,randFloatSpread:l1,seededRandom:c1,degToRad:h1,radToDeg:u1,isPowerOfTwo:f1,ceilPowerOfTwo:d1,floorPowerOfTwo:np,setQuaternionFromProperEuler:p1,normalize:bx,denormalize:xx},we=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ft(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ft(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ei=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],d=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==f||c!==d||h!==p){let m=l*f+c*d+h*p+u*x;m<0&&(f=-f,d=-d,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let b=Math.acos(m),M=Math.sin(b);g=Math.sin(g*b)/M,a=Math.sin(a*b)/M,l=l*g+f*a,c=c*g+d*a,h=h*g+p*a,u=u*g+x*a}else{l=l*g+f*a,c=c*g+d*a,h=h*g+p*a,u=u*g+x*a;let b=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=b,c*=b,h*=b,u*=b}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+h*u+l*d-c*f,e[t+1]=l*p+h*f+c*u-a*d,e[t+2]=c*p+h*d+a*f-l*u,e[t+3]=h*p-a*u-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"YXZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"ZXY":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"ZYX":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"YZX":this._x=f*h*u+c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u-f*d*p;break;case"XZY":this._x=f*h*u-c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u+f*d*p;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],f=n+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ft(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},N=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Zg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Zg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ft(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Yf.copy(this).projectOnVector(e),this.sub(Yf)}reflect(e){return this.sub(Yf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ft(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Yf=new N,Zg=new Ei,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],d=n[5],p=n[8],x=s[0],m=s[3],g=s[6],b=s[1],M=s[4],y=s[7],R=s[2],S=s[5],v=s[8];return r[0]=o*x+a*b+l*R,r[3]=o*m+a*M+l*S,r[6]=o*g+a*y+l*v,r[1]=c*x+h*b+u*R,r[4]=c*m+h*M+u*S,r[7]=c*g+h*y+u*v,r[2]=f*x+d*b+p*R,r[5]=f*m+d*M+p*S,r[8]=f*g+d*y+p*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,p=t*u+n*f+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return e[0]=u*x,e[1]=(s*c-h*n)*x,e[2]=(a*n-s*o)*x,e[3]=f*x,e[4]=(h*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=d*x,e[7]=(n*l-c*t)*x,e[8]=(o*t-n*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Fa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Zf.makeScale(e,t)),this}rotate(e){return Fa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Zf.makeRotation(-e)),this}translate(e,t){return Fa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Zf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Zf=new it,jg=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Jg=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function m1(){let i={enabled:!0,workingColorSpace:Va,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=zs(s.r),s.g=zs(s.g),s.b=zs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=Do(s.r),s.g=Do(s.g),s.b=Do(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ks?Ga:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Va]:{primaries:e,whitePoint:n,transfer:Ga,toXYZ:jg,fromXYZ:Jg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ri},outputColorSpaceConfig:{drawingBufferColorSpace:ri}},[ri]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:jg,fromXYZ:Jg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ri}}}),i}var bt=m1();function zs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Do(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var vo,Xc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{vo===void 0&&(vo=Wa("canvas")),vo.width=e.width,vo.height=e.height;let s=vo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=vo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Wa("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=zs(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(zs(t[n]/255)*255):t[n]=zs(t[n]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},g1=0,ko=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:g1++}),this.uuid=qr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(jf(s[o].image)):r.push(jf(s[o]))}else r=jf(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function jf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Xc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var x1=0,Jf=new N,fi=class i extends Qi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=xs,s=xs,r=ai,o=js,a=is,l=di,c=i.DEFAULT_ANISOTROPY,h=Ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:x1++}),this.uuid=qr(),this.name="",this.source=new ko(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new we(0,0),this.repeat=new we(1,1),this.center=new we(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Jf).x}get height(){return this.source.getSize(Jf).y}get depth(){return this.source.getSize(Jf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Gd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Vc:e.x=e.x-Math.floor(e.x);break;case xs:e.x=e.x<0?0:1;break;case Gc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Vc:e.y=e.y-Math.floor(e.y);break;case xs:e.y=e.y<0?0:1;break;case Gc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};fi.DEFAULT_IMAGE=null;fi.DEFAULT_MAPPING=Gd;fi.DEFAULT_ANISOTROPY=1;var en=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,y=(d+1)/2,R=(g+1)/2,S=(h+f)/4,v=(u+x)/4,w=(p+m)/4;return M>y&&M>R?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=S/n,r=v/n):y>R?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=S/s,r=w/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=v/r,s=w/r),this.set(n,s,r,t),this}let b=Math.sqrt((m-p)*(m-p)+(u-x)*(u-x)+(f-h)*(f-h));return Math.abs(b)<.001&&(b=1),this.x=(m-p)/b,this.y=(u-x)/b,this.z=(f-h)/b,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this.w=ft(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this.w=ft(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ft(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},qc=class extends Qi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ai,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new en(0,0,e,t),this.scissorTest=!1,this.viewport=new en(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new fi({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ai,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ko(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Xn=class extends qc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Xa=class extends fi{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=xs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var $c=class extends fi{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=xs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var wt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,f,d,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,f,d,p,x,m)}set(e,t,n,s,r,o,a,l,c,h,u,f,d,p,x,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=f,g[3]=d,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/yo.setFromMatrixColumn(e,0).length(),r=1/yo.setFromMatrixColumn(e,1).length(),o=1/yo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let f=o*h,d=o*u,p=a*h,x=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=d+p*c,t[5]=f-x*c,t[9]=-a*l,t[2]=x-f*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*h,d=l*u,p=c*h,x=c*u;t[0]=f+x*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=d*a-p,t[6]=x+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*h,d=l*u,p=c*h,x=c*u;t[0]=f-x*a,t[4]=-o*u,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*h,t[9]=x-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*h,d=o*u,p=a*h,x=a*u;t[0]=l*h,t[4]=p*c-d,t[8]=f*c+x,t[1]=l*u,t[5]=x*c+f,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,p=a*l,x=a*c;t[0]=l*h,t[4]=x-f*u,t[8]=p*u+d,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=d*u+p,t[10]=f-x*u}else if(e.order==="XZY"){let f=o*l,d=o*c,p=a*l,x=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=f*u+x,t[5]=o*h,t[9]=d*u-p,t[2]=p*u-d,t[6]=a*h,t[10]=x*u+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(b1,e,v1)}lookAt(e,t,n){let s=this.elements;return wi.subVectors(e,t),wi.lengthSq()===0&&(wi.z=1),wi.normalize(),hr.crossVectors(n,wi),hr.lengthSq()===0&&(Math.abs(n.z)===1?wi.x+=1e-4:wi.z+=1e-4,wi.normalize(),hr.crossVectors(n,wi)),hr.normalize(),oc.crossVectors(wi,hr),s[0]=hr.x,s[4]=oc.x,s[8]=wi.x,s[1]=hr.y,s[5]=oc.y,s[9]=wi.y,s[2]=hr.z,s[6]=oc.z,s[10]=wi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],d=n[13],p=n[2],x=n[6],m=n[10],g=n[14],b=n[3],M=n[7],y=n[11],R=n[15],S=s[0],v=s[4],w=s[8],C=s[12],P=s[1],I=s[5],O=s[9],z=s[13],U=s[2],G=s[6],q=s[10],H=s[14],ae=s[3],Y=s[7],ee=s[11],te=s[15];return r[0]=o*S+a*P+l*U+c*ae,r[4]=o*v+a*I+l*G+c*Y,r[8]=o*w+a*O+l*q+c*ee,r[12]=o*C+a*z+l*H+c*te,r[1]=h*S+u*P+f*U+d*ae,r[5]=h*v+u*I+f*G+d*Y,r[9]=h*w+u*O+f*q+d*ee,r[13]=h*C+u*z+f*H+d*te,r[2]=p*S+x*P+m*U+g*ae,r[6]=p*v+x*I+m*G+g*Y,r[10]=p*w+x*O+m*q+g*ee,r[14]=p*C+x*z+m*H+g*te,r[3]=b*S+M*P+y*U+R*ae,r[7]=b*v+M*I+y*G+R*Y,r[11]=b*w+M*O+y*q+R*ee,r[15]=b*C+M*z+y*H+R*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],f=e[10],d=e[14],p=e[3],x=e[7],m=e[11],g=e[15],b=l*d-c*f,M=a*d-c*u,y=a*f-l*u,R=o*d-c*h,S=o*f-l*h,v=o*u-a*h;return t*(x*b-m*M+g*y)-n*(p*b-m*R+g*S)+s*(p*M-x*R+g*v)-r*(p*y-x*S+m*v)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],f=e[10],d=e[11],p=e[12],x=e[13],m=e[14],g=e[15],b=t*a-n*o,M=t*l-s*o,y=t*c-r*o,R=n*l-s*a,S=n*c-r*a,v=s*c-r*l,w=h*x-u*p,C=h*m-f*p,P=h*g-d*p,I=u*m-f*x,O=u*g-d*x,z=f*g-d*m,U=b*z-M*O+y*I+R*P-S*C+v*w;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/U;return e[0]=(a*z-l*O+c*I)*G,e[1]=(s*O-n*z-r*I)*G,e[2]=(x*v-m*S+g*R)*G,e[3]=(f*S-u*v-d*R)*G,e[4]=(l*P-o*z-c*C)*G,e[5]=(t*z-s*P+r*C)*G,e[6]=(m*y-p*v-g*M)*G,e[7]=(h*v-f*y+d*M)*G,e[8]=(o*O-a*P+c*w)*G,e[9]=(n*P-t*O-r*w)*G,e[10]=(p*S-x*y+g*b)*G,e[11]=(u*y-h*S-d*b)*G,e[12]=(a*C-o*I-l*w)*G,e[13]=(t*I-n*C+s*w)*G,e[14]=(x*M-p*R-m*b)*G,e[15]=(h*R-u*M+f*b)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,p=r*u,x=o*h,m=o*u,g=a*u,b=l*c,M=l*h,y=l*u,R=n.x,S=n.y,v=n.z;return s[0]=(1-(x+g))*R,s[1]=(d+y)*R,s[2]=(p-M)*R,s[3]=0,s[4]=(d-y)*S,s[5]=(1-(f+g))*S,s[6]=(m+b)*S,s[7]=0,s[8]=(p+M)*v,s[9]=(m-b)*v,s[10]=(1-(f+x))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=yo.set(s[0],s[1],s[2]).length(),a=yo.set(s[4],s[5],s[6]).length(),l=yo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ji.copy(this);let c=1/o,h=1/a,u=1/l;return ji.elements[0]*=c,ji.elements[1]*=c,ji.elements[2]*=c,ji.elements[4]*=h,ji.elements[5]*=h,ji.elements[6]*=h,ji.elements[8]*=u,ji.elements[9]*=u,ji.elements[10]*=u,t.setFromRotationMatrix(ji),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=ki,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),f=(t+e)/(t-e),d=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===ki)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Uo)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=ki,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),f=-(t+e)/(t-e),d=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===ki)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Uo)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},yo=new N,ji=new wt,b1=new N(0,0,0),v1=new N(1,1,1),hr=new N,oc=new N,wi=new N,Kg=new wt,Qg=new Ei,Vs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(ft(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ft(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ft(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ft(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ft(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ft(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Kg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Kg,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Qg.setFromEuler(this),this.setFromQuaternion(Qg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Vs.DEFAULT_ORDER="XYZ";var Bo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},y1=0,e0=new N,_o=new Ei,Us=new wt,ac=new N,Ra=new N,_1=new N,M1=new Ei,t0=new N(1,0,0),n0=new N(0,1,0),i0=new N(0,0,1),s0={type:"added"},w1={type:"removed"},Mo={type:"childadded",child:null},Kf={type:"childremoved",child:null},tn=class i extends Qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:y1++}),this.uuid=qr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new N,t=new Vs,n=new Ei,s=new N(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new wt},normalMatrix:{value:new it}}),this.matrix=new wt,this.matrixWorld=new wt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Bo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return _o.setFromAxisAngle(e,t),this.quaternion.multiply(_o),this}rotateOnWorldAxis(e,t){return _o.setFromAxisAngle(e,t),this.quaternion.premultiply(_o),this}rotateX(e){return this.rotateOnAxis(t0,e)}rotateY(e){return this.rotateOnAxis(n0,e)}rotateZ(e){return this.rotateOnAxis(i0,e)}translateOnAxis(e,t){return e0.copy(e).applyQuaternion(this.quaternion),this.position.add(e0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(t0,e)}translateY(e){return this.translateOnAxis(n0,e)}translateZ(e){return this.translateOnAxis(i0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Us.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?ac.copy(e):ac.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ra.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Us.lookAt(Ra,ac,this.up):Us.lookAt(ac,Ra,this.up),this.quaternion.setFromRotationMatrix(Us),s&&(Us.extractRotation(s.matrixWorld),_o.setFromRotationMatrix(Us),this.quaternion.premultiply(_o.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(et("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(s0),Mo.child=e,this.dispatchEvent(Mo),Mo.child=null):et("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(w1),Kf.child=e,this.dispatchEvent(Kf),Kf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Us.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Us.multiply(e.parent.matrixWorld)),e.applyMatrix4(Us),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(s0),Mo.child=e,this.dispatchEvent(Mo),Mo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ra,e,_1),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ra,M1,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),f=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};tn.DEFAULT_UP=new N(0,1,0);tn.DEFAULT_MATRIX_AUTO_UPDATE=!0;tn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var jt=class extends tn{constructor(){super(),this.isGroup=!0,this.type="Group"}},S1={type:"move"},zo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new jt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new jt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new N,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new N),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new jt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new N,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new N,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let m=t.getJointPose(x,n),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,p=.005;c.inputState.pinching&&f>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(S1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new jt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},vx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ur={h:0,s:0,l:0},lc={h:0,s:0,l:0};function Qf(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var qe=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ri){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,bt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=bt.workingColorSpace){return this.r=e,this.g=t,this.b=n,bt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=bt.workingColorSpace){if(e=tp(e,1),t=ft(t,0,1),n=ft(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Qf(o,r,e+1/3),this.g=Qf(o,r,e),this.b=Qf(o,r,e-1/3)}return bt.colorSpaceToWorking(this,s),this}setStyle(e,t=ri){function n(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ri){let n=vx[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=zs(e.r),this.g=zs(e.g),this.b=zs(e.b),this}copyLinearToSRGB(e){return this.r=Do(e.r),this.g=Do(e.g),this.b=Do(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ri){return bt.workingToColorSpace(jn.copy(this),e),Math.round(ft(jn.r*255,0,255))*65536+Math.round(ft(jn.g*255,0,255))*256+Math.round(ft(jn.b*255,0,255))}getHexString(e=ri){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=bt.workingColorSpace){bt.workingToColorSpace(jn.copy(this),t);let n=jn.r,s=jn.g,r=jn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=bt.workingColorSpace){return bt.workingToColorSpace(jn.copy(this),t),e.r=jn.r,e.g=jn.g,e.b=jn.b,e}getStyle(e=ri){bt.workingToColorSpace(jn.copy(this),e);let t=jn.r,n=jn.g,s=jn.b;return e!==ri?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ur),this.setHSL(ur.h+e,ur.s+t,ur.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ur),e.getHSL(lc);let n=ka(ur.h,lc.h,t),s=ka(ur.s,lc.s,t),r=ka(ur.l,lc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},jn=new qe;qe.NAMES=vx;var qa=class extends tn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Vs,this.environmentIntensity=1,this.environmentRotation=new Vs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ji=new N,Fs=new N,ed=new N,Os=new N,wo=new N,So=new N,r0=new N,td=new N,nd=new N,id=new N,sd=new en,rd=new en,od=new en,mr=class i{constructor(e=new N,t=new N,n=new N){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ji.subVectors(e,t),s.cross(Ji);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ji.subVectors(s,t),Fs.subVectors(n,t),ed.subVectors(e,t);let o=Ji.dot(Ji),a=Ji.dot(Fs),l=Ji.dot(ed),c=Fs.dot(Fs),h=Fs.dot(ed),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,p=(o*h-a*l)*f;return r.set(1-d-p,p,d)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Os)===null?!1:Os.x>=0&&Os.y>=0&&Os.x+Os.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Os)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Os.x),l.addScaledVector(o,Os.y),l.addScaledVector(a,Os.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return sd.setScalar(0),rd.setScalar(0),od.setScalar(0),sd.fromBufferAttribute(e,t),rd.fromBufferAttribute(e,n),od.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(sd,r.x),o.addScaledVector(rd,r.y),o.addScaledVector(od,r.z),o}static isFrontFacing(e,t,n,s){return Ji.subVectors(n,t),Fs.subVectors(e,t),Ji.cross(Fs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ji.subVectors(this.c,this.b),Fs.subVectors(this.a,this.b),Ji.cross(Fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;wo.subVectors(s,n),So.subVectors(r,n),td.subVectors(e,n);let l=wo.dot(td),c=So.dot(td);if(l<=0&&c<=0)return t.copy(n);nd.subVectors(e,s);let h=wo.dot(nd),u=So.dot(nd);if(h>=0&&u<=h)return t.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(wo,o);id.subVectors(e,r);let d=wo.dot(id),p=So.dot(id);if(p>=0&&d<=p)return t.copy(r);let x=d*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(So,a);let m=h*p-d*u;if(m<=0&&u-h>=0&&d-p>=0)return r0.subVectors(r,s),a=(u-h)/(u-h+(d-p)),t.copy(s).addScaledVector(r0,a);let g=1/(m+x+f);return o=x*g,a=f*g,t.copy(n).addScaledVector(wo,o).addScaledVector(So,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},wn=class{constructor(e=new N(1/0,1/0,1/0),t=new N(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ki):Ki.fromBufferAttribute(r,o),Ki.applyMatrix4(e.matrixWorld),this.expandByPoint(Ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),cc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),cc.copy(n.boundingBox)),cc.applyMatrix4(e.matrixWorld),this.union(cc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ki),Ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ca),hc.subVectors(this.max,Ca),Eo.subVectors(e.a,Ca),To.subVectors(e.b,Ca),Ao.subVectors(e.c,Ca),fr.subVectors(To,Eo),dr.subVectors(Ao,To),Or.subVectors(Eo,Ao);let t=[0,-fr.z,fr.y,0,-dr.z,dr.y,0,-Or.z,Or.y,fr.z,0,-fr.x,dr.z,0,-dr.x,Or.z,0,-Or.x,-fr.y,fr.x,0,-dr.y,dr.x,0,-Or.y,Or.x,0];return!ad(t,Eo,To,Ao,hc)||(t=[1,0,0,0,1,0,0,0,1],!ad(t,Eo,To,Ao,hc))?!1:(uc.crossVectors(fr,dr),t=[uc.x,uc.y,uc.z],ad(t,Eo,To,Ao,hc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ks[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ks[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ks[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ks[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ks[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ks[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ks[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ks[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ks),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ks=[new N,new N,new N,new N,new N,new N,new N,new N],Ki=new N,cc=new wn,Eo=new N,To=new N,Ao=new N,fr=new N,dr=new N,Or=new N,Ca=new N,hc=new N,uc=new N,kr=new N;function ad(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){kr.fromArray(i,r);let a=s.x*Math.abs(kr.x)+s.y*Math.abs(kr.y)+s.z*Math.abs(kr.z),l=e.dot(kr),c=t.dot(kr),h=n.dot(kr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Mn=new N,fc=new we,E1=0,mn=class extends Qi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:E1++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=fx,this.updateRanges=[],this.gpuType=Gi,this.version=0,this._normalizationScale=e!==void 0?ip(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)fc.fromBufferAttribute(this,t),fc.applyMatrix3(e),this.setXY(t,fc.x,fc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyMatrix3(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyMatrix4(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyNormalMatrix(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.transformDirection(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):xx(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):bx(e,this.array)}};var $a=class extends mn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ya=class extends mn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var rt=class extends mn{constructor(e,t,n){super(new Float32Array(e),t,n)}},T1=new wn,Pa=new N,ld=new N,Bi=class{constructor(e=new N,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):T1.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Pa.subVectors(e,this.center);let t=Pa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Pa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ld.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Pa.copy(e.center).add(ld)),this.expandByPoint(Pa.copy(e.center).sub(ld))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},A1=0,Oi=new wt,cd=new tn,Ro=new N,Si=new wn,Ia=new wn,kn=new N,vt=class i extends Qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:A1++}),this.uuid=qr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(K_(e)?Ya:$a)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new it().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Oi.makeRotationFromQuaternion(e),this.applyMatrix4(Oi),this}rotateX(e){return Oi.makeRotationX(e),this.applyMatrix4(Oi),this}rotateY(e){return Oi.makeRotationY(e),this.applyMatrix4(Oi),this}rotateZ(e){return Oi.makeRotationZ(e),this.applyMatrix4(Oi),this}translate(e,t,n){return Oi.makeTranslation(e,t,n),this.applyMatrix4(Oi),this}scale(e,t,n){return Oi.makeScale(e,t,n),this.applyMatrix4(Oi),this}lookAt(e){return cd.lookAt(e),cd.updateMatrix(),this.applyMatrix4(cd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ro).negate(),this.translate(Ro.x,Ro.y,Ro.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new rt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new wn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new N(-1/0,-1/0,-1/0),new N(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];Si.setFromBufferAttribute(r),this.morphTargetsRelative?(kn.addVectors(this.boundingBox.min,Si.min),this.boundingBox.expandByPoint(kn),kn.addVectors(this.boundingBox.max,Si.max),this.boundingBox.expandByPoint(kn)):(this.boundingBox.expandByPoint(Si.min),this.boundingBox.expandByPoint(Si.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&et('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Bi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new N,1/0);return}if(e){let n=this.boundingSphere.center;if(Si.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ia.setFromBufferAttribute(a),this.morphTargetsRelative?(kn.addVectors(Si.min,Ia.min),Si.expandByPoint(kn),kn.addVectors(Si.max,Ia.max),Si.expandByPoint(kn)):(Si.expandByPoint(Ia.min),Si.expandByPoint(Ia.max))}Si.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)kn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(kn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)kn.fromBufferAttribute(a,c),l&&(Ro.fromBufferAttribute(e,c),kn.add(Ro)),s=Math.max(s,n.distanceToSquared(kn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&et('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){et("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new mn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let C=0;C<n.count;C++)a[C]=new N,l[C]=new N;let h=new N,u=new N,f=new N,d=new we,p=new we,x=new we,m=new N,g=new N;function b(C,P,I){c[C]=c[P]=c[I]=1,h.fromBufferAttribute(n,C),u.fromBufferAttribute(n,P),f.fromBufferAttribute(n,I),d.fromBufferAttribute(r,C),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,I),u.sub(h),f.sub(h),p.sub(d),x.sub(d);let O=1/(p.x*x.y-x.x*p.y);isFinite(O)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(f,-p.y).multiplyScalar(O),g.copy(f).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(O),a[C].add(m),a[P].add(m),a[I].add(m),l[C].add(g),l[P].add(g),l[I].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let C=0,P=M.length;C<P;++C){let I=M[C],O=I.start,z=I.count;for(let U=O,G=O+z;U<G;U+=3)b(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let y=new N,R=new N,S=new N,v=new N;function w(C){S.fromBufferAttribute(s,C),v.copy(S);let P=a[C];y.copy(P),y.sub(S.multiplyScalar(S.dot(P))).normalize(),R.crossVectors(v,P);let O=R.dot(l[C])<0?-1:1;o.setXYZW(C,y.x,y.y,y.z,O)}for(let C=0,P=n.count;C<P;++C)c[C]&&w(C);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new mn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new N,r=new N,o=new N,a=new N,l=new N,c=new N,h=new N,u=new N;if(e)for(let f=0,d=e.count;f<d;f+=3){let p=e.getX(f+0),x=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)kn.fromBufferAttribute(e,t),kn.normalize(),e.setXYZ(t,kn.x,kn.y,kn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?d=l[x]*a.data.stride+a.offset:d=l[x]*h;for(let g=0;g<h;g++)f[p++]=c[d++]}return new mn(f,h,u)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=e(f,n);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var hd=new N,R1=new N,C1=new it,oi=class{constructor(e=new N(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=hd.subVectors(n,t).cross(R1.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(hd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||C1.getNormalMatrix(e),s=this.coplanarPoint(hd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},P1=0,vs=class extends Qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:P1++}),this.uuid=qr(),this.name="",this.type="Material",this.blending=Yo,this.side=Ms,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Nd,this.blendDst=Ud,this.blendEquation=Gr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new qe(0,0,0),this.blendAlpha=0,this.depthFunc=No,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ox,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Nc,this.stencilZFail=Nc,this.stencilZPass=Nc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new qe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new oi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new we().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new we().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Bs=new N,ud=new N,dc=new N,pc=new N,Gs=class{constructor(e=new N,t=new N(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Bs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Bs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Bs.copy(this.origin).addScaledVector(this.direction,t),Bs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){ud.copy(e).add(t).multiplyScalar(.5),dc.copy(t).sub(e).normalize(),pc.copy(this.origin).sub(ud);let r=e.distanceTo(t)*.5,o=-this.direction.dot(dc),a=pc.dot(this.direction),l=-pc.dot(dc),c=pc.lengthSq(),h=Math.abs(1-o*o),u,f,d,p;if(h>0)if(u=o*l-a,f=o*a-l,p=r*h,u>=0)if(f>=-p)if(f<=p){let x=1/h;u*=x,f*=x,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-p?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=p?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(ud).addScaledVector(dc,f),d}intersectSphere(e,t){if(e.radius<0)return null;Bs.subVectors(e.center,this.origin);let n=Bs.dot(this.direction),s=Bs.dot(Bs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),h>=0?(r=(e.min.y-f.y)*h,o=(e.max.y-f.y)*h):(r=(e.max.y-f.y)*h,o=(e.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-f.z)*u,l=(e.max.z-f.z)*u):(a=(e.max.z-f.z)*u,l=(e.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Bs)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,f=e.y-o.y,d=e.z-o.z,p=t.x-o.x,x=t.y-o.y,m=t.z-o.z,g=n.x-o.x,b=n.y-o.y,M=n.z-o.z,y=Math.abs(l),R=Math.abs(c),S=Math.abs(h),v,w,C,P,I,O,z,U,G,q,H,ae;if(y>=R&&y>=S?(C=l,O=u,G=p,ae=g,l>=0?(v=c,w=h,P=f,I=d,z=x,U=m,q=b,H=M):(v=h,w=c,P=d,I=f,z=m,U=x,q=M,H=b)):R>=S?(C=c,O=f,G=x,ae=b,c>=0?(v=h,w=l,P=d,I=u,z=m,U=p,q=M,H=g):(v=l,w=h,P=u,I=d,z=p,U=m,q=g,H=M)):(C=h,O=d,G=m,ae=M,h>=0?(v=l,w=c,P=u,I=f,z=p,U=x,q=g,H=b):(v=c,w=l,P=f,I=u,z=x,U=p,q=b,H=g)),C===0)return null;let Y=v/C,ee=w/C,te=1/C,de=P-Y*O,ce=I-ee*O,J=z-Y*G,ue=U-ee*G,ge=q-Y*ae,Se=H-ee*ae,be=ge*ue-Se*J,Ge=de*Se-ce*ge,tt=J*ce-ue*de;if(s){if(be<0||Ge<0||tt<0)return null}else if((be<0||Ge<0||tt<0)&&(be>0||Ge>0||tt>0))return null;let He=be+Ge+tt;if(He===0)return null;let lt=te*(be*O+Ge*G+tt*ae);return(He>0?lt<0:lt>0)?null:this.at(lt/He,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},qn=class extends vs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Vs,this.combine=bh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},o0=new wt,Br=new Gs,mc=new Bi,a0=new N,gc=new N,xc=new N,bc=new N,fd=new N,vc=new N,l0=new N,yc=new N,Ot=class extends tn{constructor(e=new vt,t=new qn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){vc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(fd.fromBufferAttribute(u,e),o?vc.addScaledVector(fd,h):vc.addScaledVector(fd.sub(t),h))}t.add(vc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),mc.copy(n.boundingSphere),mc.applyMatrix4(r),Br.copy(e.ray).recast(e.near),!(mc.containsPoint(Br.origin)===!1&&(Br.intersectSphere(mc,a0)===null||Br.origin.distanceToSquared(a0)>(e.far-e.near)**2))&&(o0.copy(r).invert(),Br.copy(e.ray).applyMatrix4(o0),!(n.boundingBox!==null&&Br.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Br)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=f.length;p<x;p++){let m=f[p],g=o[m.materialIndex],b=Math.max(m.start,d.start),M=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let y=b,R=M;y<R;y+=3){let S=a.getX(y),v=a.getX(y+1),w=a.getX(y+2);s=_c(this,g,e,n,c,h,u,S,v,w),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),x=Math.min(a.count,d.start+d.count);for(let m=p,g=x;m<g;m+=3){let b=a.getX(m),M=a.getX(m+1),y=a.getX(m+2);s=_c(this,o,e,n,c,h,u,b,M,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=f.length;p<x;p++){let m=f[p],g=o[m.materialIndex],b=Math.max(m.start,d.start),M=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let y=b,R=M;y<R;y+=3){let S=y,v=y+1,w=y+2;s=_c(this,g,e,n,c,h,u,S,v,w),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),x=Math.min(l.count,d.start+d.count);for(let m=p,g=x;m<g;m+=3){let b=m,M=m+1,y=m+2;s=_c(this,o,e,n,c,h,u,b,M,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function I1(i,e,t,n,s,r,o,a){let l;if(e.side===li?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===Ms,a),l===null)return null;yc.copy(a),yc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(yc);return c<t.near||c>t.far?null:{distance:c,point:yc.clone(),object:i}}function _c(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,gc),i.getVertexPosition(l,xc),i.getVertexPosition(c,bc);let h=I1(i,e,t,n,gc,xc,bc,l0);if(h){let u=new N;mr.getBarycoord(l0,gc,xc,bc,u),s&&(h.uv=mr.getInterpolatedAttribute(s,a,l,c,u,new we)),r&&(h.uv1=mr.getInterpolatedAttribute(r,a,l,c,u,new we)),o&&(h.normal=mr.getInterpolatedAttribute(o,a,l,c,u,new N),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new N,materialIndex:0};mr.getNormal(gc,xc,bc,f.normal),h.face=f,h.barycoord=u}return h}var Ws=class extends fi{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Wt,h=Wt,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Za=class extends mn{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Co=new wt,c0=new wt,Mc=[],h0=new wn,L1=new wt,La=new Ot,Da=new Bi,Xs=class extends Ot{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Za(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,L1)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new wn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Co),h0.copy(e.boundingBox).applyMatrix4(Co),this.boundingBox.union(h0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Bi),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Co),Da.copy(e.boundingSphere).applyMatrix4(Co),this.boundingSphere.union(Da)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(La.geometry=this.geometry,La.material=this.material,La.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Da.copy(this.boundingSphere),Da.applyMatrix4(n),e.ray.intersectsSphere(Da)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Co),c0.multiplyMatrices(n,Co),La.matrixWorld=c0,La.raycast(e,Mc);for(let o=0,a=Mc.length;o<a;o++){let l=Mc[o];l.instanceId=r,l.object=this,t.push(l)}Mc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Za(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Ws(new Float32Array(s*this.count),s,this.count,Eh,Gi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},zr=new Bi,D1=new we(.5,.5),wc=new N,gr=class{constructor(e=new oi,t=new oi,n=new oi,s=new oi,r=new oi,o=new oi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=ki,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],p=r[8],x=r[9],m=r[10],g=r[11],b=r[12],M=r[13],y=r[14],R=r[15];if(s[0].setComponents(c-o,d-h,g-p,R-b).normalize(),s[1].setComponents(c+o,d+h,g+p,R+b).normalize(),s[2].setComponents(c+a,d+u,g+x,R+M).normalize(),s[3].setComponents(c-a,d-u,g-x,R-M).normalize(),n)s[4].setComponents(l,f,m,y).normalize(),s[5].setComponents(c-l,d-f,g-m,R-y).normalize();else if(s[4].setComponents(c-l,d-f,g-m,R-y).normalize(),t===ki)s[5].setComponents(c+l,d+f,g+m,R+y).normalize();else if(t===Uo)s[5].setComponents(l,f,m,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),zr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),zr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(zr)}intersectsSprite(e){zr.center.set(0,0,0);let t=D1.distanceTo(e.center);return zr.radius=.7071067811865476+t,zr.applyMatrix4(e.matrixWorld),this.intersectsSphere(zr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(wc.x=s.normal.x>0?e.max.x:e.min.x,wc.y=s.normal.y>0?e.max.y:e.min.y,wc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(wc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},u0=new wt,Yc=class i{constructor(){this.coordinateSystem=ki,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];u0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new gr),n[s].setFromProjectionMatrix(u0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new gr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var zi=class extends vs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new qe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Zc=new N,jc=new N,f0=new wt,Na=new Gs,Sc=new Bi,dd=new N,d0=new N,Ho=class extends tn{constructor(e=new vt,t=new zi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Zc.fromBufferAttribute(t,s-1),jc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Zc.distanceTo(jc);e.setAttribute("lineDistance",new rt(n,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Sc.copy(n.boundingSphere),Sc.applyMatrix4(s),Sc.radius+=r,e.ray.intersectsSphere(Sc)===!1)return;f0.copy(s).invert(),Na.copy(e.ray).applyMatrix4(f0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=d,m=p-1;x<m;x+=c){let g=h.getX(x),b=h.getX(x+1),M=Ec(this,e,Na,l,g,b,x);M&&t.push(M)}if(this.isLineLoop){let x=h.getX(p-1),m=h.getX(d),g=Ec(this,e,Na,l,x,m,p-1);g&&t.push(g)}}else{let d=Math.max(0,o.start),p=Math.min(f.count,o.start+o.count);for(let x=d,m=p-1;x<m;x+=c){let g=Ec(this,e,Na,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){let x=Ec(this,e,Na,l,p-1,d,p-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ec(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Zc.fromBufferAttribute(a,s),jc.fromBufferAttribute(a,r),t.distanceSqToSegment(Zc,jc,dd,d0)>n)return;dd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(dd);if(!(c<e.near||c>e.far))return{distance:c,point:d0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var p0=new N,m0=new N,qs=class extends Ho{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)p0.fromBufferAttribute(t,s),m0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+p0.distanceTo(m0);e.setAttribute("lineDistance",new rt(n,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ys=class extends vs{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new qe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},g0=new wt,Md=new Gs,Tc=new Bi,Ac=new N,$s=class extends tn{constructor(e=new vt,t=new ys){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Tc.copy(n.boundingSphere),Tc.applyMatrix4(s),Tc.radius+=r,e.ray.intersectsSphere(Tc)===!1)return;g0.copy(s).invert(),Md.copy(e.ray).applyMatrix4(g0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let p=f,x=d;p<x;p++){let m=c.getX(p);Ac.fromBufferAttribute(u,m),x0(Ac,m,l,s,e,t,this)}}else{let f=Math.max(0,o.start),d=Math.min(u.count,o.start+o.count);for(let p=f,x=d;p<x;p++)Ac.fromBufferAttribute(u,p),x0(Ac,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function x0(i,e,t,n,s,r,o){let a=Md.distanceSqToPoint(i);if(a<t){let l=new N;Md.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var ja=class extends fi{constructor(e=[],t=Wr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var es=class extends fi{constructor(e,t,n=Ci,s,r,o,a=Wt,l=Wt,c,h=Hs,u=1){if(h!==Hs&&h!==Js)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:u};super(f,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ko(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ja=class extends es{constructor(e,t=Ci,n=Wr,s,r,o=Wt,a=Wt,l,c=Hs){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ka=class extends fi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},xr=class i extends vt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new rt(c,3)),this.setAttribute("normal",new rt(h,3)),this.setAttribute("uv",new rt(u,2));function p(x,m,g,b,M,y,R,S,v,w,C){let P=y/v,I=R/w,O=y/2,z=R/2,U=S/2,G=v+1,q=w+1,H=0,ae=0,Y=new N;for(let ee=0;ee<q;ee++){let te=ee*I-z;for(let de=0;de<G;de++){let ce=de*P-O;Y[x]=ce*b,Y[m]=te*M,Y[g]=U,c.push(Y.x,Y.y,Y.z),Y[x]=0,Y[m]=0,Y[g]=S>0?1:-1,h.push(Y.x,Y.y,Y.z),u.push(de/v),u.push(1-ee/w),H+=1}}for(let ee=0;ee<w;ee++)for(let te=0;te<v;te++){let de=f+te+G*ee,ce=f+te+G*(ee+1),J=f+(te+1)+G*(ee+1),ue=f+(te+1)+G*ee;l.push(de,ce,ue),l.push(ce,J,ue),ae+=6}a.addGroup(d,ae,C),d+=ae,f+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ys=class i extends vt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],p=0,x=[],m=n/2,g=0;b(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new rt(u,3)),this.setAttribute("normal",new rt(f,3)),this.setAttribute("uv",new rt(d,2));function b(){let y=new N,R=new N,S=0,v=(t-e)/n;for(let w=0;w<=r;w++){let C=[],P=w/r,I=P*(t-e)+e;for(let O=0;O<=s;O++){let z=O/s,U=z*l+a,G=Math.sin(U),q=Math.cos(U);R.x=I*G,R.y=-P*n+m,R.z=I*q,u.push(R.x,R.y,R.z),y.set(G,v,q).normalize(),f.push(y.x,y.y,y.z),d.push(z,1-P),C.push(p++)}x.push(C)}for(let w=0;w<s;w++)for(let C=0;C<r;C++){let P=x[C][w],I=x[C+1][w],O=x[C+1][w+1],z=x[C][w+1];(e>0||C!==0)&&(h.push(P,I,z),S+=3),(t>0||C!==r-1)&&(h.push(I,O,z),S+=3)}c.addGroup(g,S,0),g+=S}function M(y){let R=p,S=new we,v=new N,w=0,C=y===!0?e:t,P=y===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,m*P,0),f.push(0,P,0),d.push(.5,.5),p++;let I=p;for(let O=0;O<=s;O++){let U=O/s*l+a,G=Math.cos(U),q=Math.sin(U);v.x=C*q,v.y=m*P,v.z=C*G,u.push(v.x,v.y,v.z),f.push(0,P,0),S.x=G*.5+.5,S.y=q*.5*P+.5,d.push(S.x,S.y),p++}for(let O=0;O<s;O++){let z=R+O,U=I+O;y===!0?h.push(U,U+1,z):h.push(U+1,U,z),w+=3}c.addGroup(g,w,y===!0?1:2),g+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Qa=class i extends Ys{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Jc=class i extends vt{constructor(e=[],t=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:n,detail:s};let r=[],o=[];a(s),c(n),h(),this.setAttribute("position",new rt(r,3)),this.setAttribute("normal",new rt(r.slice(),3)),this.setAttribute("uv",new rt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(b){let M=new N,y=new N,R=new N;for(let S=0;S<t.length;S+=3)d(t[S+0],M),d(t[S+1],y),d(t[S+2],R),l(M,y,R,b)}function l(b,M,y,R){let S=R+1,v=[];for(let w=0;w<=S;w++){v[w]=[];let C=b.clone().lerp(y,w/S),P=M.clone().lerp(y,w/S),I=S-w;for(let O=0;O<=I;O++)O===0&&w===S?v[w][O]=C:v[w][O]=C.clone().lerp(P,O/I)}for(let w=0;w<S;w++)for(let C=0;C<2*(S-w)-1;C++){let P=Math.floor(C/2);C%2===0?(f(v[w][P+1]),f(v[w+1][P]),f(v[w][P])):(f(v[w][P+1]),f(v[w+1][P+1]),f(v[w+1][P]))}}function c(b){let M=new N;for(let y=0;y<r.length;y+=3)M.x=r[y+0],M.y=r[y+1],M.z=r[y+2],M.normalize().multiplyScalar(b),r[y+0]=M.x,r[y+1]=M.y,r[y+2]=M.z}function h(){let b=new N;for(let M=0;M<r.length;M+=3){b.x=r[M+0],b.y=r[M+1],b.z=r[M+2];let y=m(b)/2/Math.PI+.5,R=g(b)/Math.PI+.5;o.push(y,1-R)}p(),u()}function u(){for(let b=0;b<o.length;b+=6){let M=o[b+0],y=o[b+2],R=o[b+4],S=Math.max(M,y,R),v=Math.min(M,y,R);S>.9&&v<.1&&(M<.2&&(o[b+0]+=1),y<.2&&(o[b+2]+=1),R<.2&&(o[b+4]+=1))}}function f(b){r.push(b.x,b.y,b.z)}function d(b,M){let y=b*3;M.x=e[y+0],M.y=e[y+1],M.z=e[y+2]}function p(){let b=new N,M=new N,y=new N,R=new N,S=new we,v=new we,w=new we;for(let C=0,P=0;C<r.length;C+=9,P+=6){b.set(r[C+0],r[C+1],r[C+2]),M.set(r[C+3],r[C+4],r[C+5]),y.set(r[C+6],r[C+7],r[C+8]),S.set(o[P+0],o[P+1]),v.set(o[P+2],o[P+3]),w.set(o[P+4],o[P+5]),R.copy(b).add(M).add(y).divideScalar(3);let I=m(R);x(S,P+0,b,I),x(v,P+2,M,I),x(w,P+4,y,I)}}function x(b,M,y,R){R<0&&b.x===1&&(o[M]=b.x-1),y.x===0&&y.z===0&&(o[M]=R/2/Math.PI+.5)}function m(b){return Math.atan2(b.z,-b.x)}function g(b){return Math.atan2(-b.y,Math.sqrt(b.x*b.x+b.z*b.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.vertices,e.indices,e.radius,e.detail)}};var Ti=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ye("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],f=n[s+1]-h,d=(o-h)/f;return(s+d)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new we:new N);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new N,s=[],r=[],o=[],a=new N,l=new wt;for(let d=0;d<=e;d++){let p=d/e;s[d]=this.getTangentAt(p,new N)}r[0]=new N,o[0]=new N;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),f=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let d=1;d<=e;d++){if(r[d]=r[d-1].clone(),o[d]=o[d-1].clone(),a.crossVectors(s[d-1],s[d]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(ft(s[d-1].dot(s[d]),-1,1));r[d].applyMatrix4(l.makeRotationAxis(a,p))}o[d].crossVectors(s[d],r[d])}if(t===!0){let d=Math.acos(ft(r[0].dot(r[e]),-1,1));d/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(d=-d);for(let p=1;p<=e;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],d*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},Vo=class extends Ti{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new we){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),f=l-this.aX,d=c-this.aY;l=f*h-d*u+this.aX,c=f*u+d*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},Kc=class extends Vo{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function sp(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let f=(o-r)/c-(a-r)/(c+h)+(a-o)/h,d=(a-o)/h-(l-o)/(h+u)+(l-a)/u;f*=h,d*=h,s(o,a,f,d)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var b0=new N,v0=new N,pd=new sp,md=new sp,gd=new sp,Hr=class extends Ti{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new N){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(v0.subVectors(s[0],s[1]).add(s[0]),c=v0);let u=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(b0.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=b0),this.curveType==="centripetal"||this.curveType==="chordal"){let d=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),d),x=Math.pow(u.distanceToSquared(f),d),m=Math.pow(f.distanceToSquared(h),d);x<1e-4&&(x=1),p<1e-4&&(p=x),m<1e-4&&(m=x),pd.initNonuniformCatmullRom(c.x,u.x,f.x,h.x,p,x,m),md.initNonuniformCatmullRom(c.y,u.y,f.y,h.y,p,x,m),gd.initNonuniformCatmullRom(c.z,u.z,f.z,h.z,p,x,m)}else this.curveType==="catmullrom"&&(pd.initCatmullRom(c.x,u.x,f.x,h.x,this.tension),md.initCatmullRom(c.y,u.y,f.y,h.y,this.tension),gd.initCatmullRom(c.z,u.z,f.z,h.z,this.tension));return n.set(pd.calc(l),md.calc(l),gd.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new N().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function y0(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function N1(i,e){let t=1-i;return t*t*e}function U1(i,e){return 2*(1-i)*i*e}function F1(i,e){return i*i*e}function Ba(i,e,t,n){return N1(i,e)+U1(i,t)+F1(i,n)}function O1(i,e){let t=1-i;return t*t*t*e}function k1(i,e){let t=1-i;return 3*t*t*i*e}function B1(i,e){return 3*(1-i)*i*i*e}function z1(i,e){return i*i*i*e}function za(i,e,t,n,s){return O1(i,e)+k1(i,t)+B1(i,n)+z1(i,s)}var el=class extends Ti{constructor(e=new we,t=new we,n=new we,s=new we){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new we){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(za(e,s.x,r.x,o.x,a.x),za(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Qc=class extends Ti{constructor(e=new N,t=new N,n=new N,s=new N){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new N){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(za(e,s.x,r.x,o.x,a.x),za(e,s.y,r.y,o.y,a.y),za(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},tl=class extends Ti{constructor(e=new we,t=new we){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new we){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new we){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},eh=class extends Ti{constructor(e=new N,t=new N){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new N){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new N){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},nl=class extends Ti{constructor(e=new we,t=new we,n=new we){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new we){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Ba(e,s.x,r.x,o.x),Ba(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},th=class extends Ti{constructor(e=new N,t=new N,n=new N){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new N){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Ba(e,s.x,r.x,o.x),Ba(e,s.y,r.y,o.y),Ba(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},il=class extends Ti{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new we){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(y0(a,l.x,c.x,h.x,u.x),y0(a,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new we().fromArray(s))}return this}},_0=Object.freeze({__proto__:null,ArcCurve:Kc,CatmullRomCurve3:Hr,CubicBezierCurve:el,CubicBezierCurve3:Qc,EllipseCurve:Vo,LineCurve:tl,LineCurve3:eh,QuadraticBezierCurve:nl,QuadraticBezierCurve3:th,SplineCurve:il}),nh=class extends Ti{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let n=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new _0[n](t,e))}return this}getPoint(e,t){let n=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let n=0,s=this.curves.length;n<s;n++)t+=this.curves[n].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(t.push(h),n=h)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this.cacheLengths=null,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,n=this.curves.length;t<n;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(new _0[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},sl=class extends nh{constructor(e){super(),this.type="Path",this.currentPoint=new we,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,n=e.length;t<n;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let n=new tl(this.currentPoint.clone(),new we(e,t));return this.curves.push(n),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,n,s){let r=new nl(this.currentPoint.clone(),new we(e,t),new we(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(e,t,n,s,r,o){let a=new el(this.currentPoint.clone(),new we(e,t),new we(n,s),new we(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),n=new il(t);return this.curves.push(n),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+a,t+l,n,s,r,o),this}absarc(e,t,n,s,r,o){return this.absellipse(e,t,n,n,s,r,o),this}ellipse(e,t,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(e+c,t+h,n,s,r,o,a,l),this}absellipse(e,t,n,s,r,o,a,l){let c=new Vo(e,t,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},Go=class extends sl{constructor(e){super(e),this.uuid=qr(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let n=0,s=this.holes.length;n<s;n++)t[n]=this.holes[n].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,n=this.holes.length;t<n;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(new sl().fromJSON(s))}return this}};function H1(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=yx(i,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=q1(i,e,r,t)),i.length>80*t){a=i[0],l=i[1];let h=a,u=l;for(let f=t;f<s;f+=t){let d=i[f],p=i[f+1];d<a&&(a=d),p<l&&(l=p),d>h&&(h=d),p>u&&(u=p)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return rl(r,o,t,a,l,c,0),o}function yx(i,e,t,n,s){let r;if(s===iM(i,e,t,n)>0)for(let o=e;o<t;o+=n)r=M0(o/n|0,i[o],i[o+1],r);else for(let o=t-n;o>=e;o-=n)r=M0(o/n|0,i[o],i[o+1],r);return r&&Wo(r,r.next)&&(al(r),r=r.next),r}function Vr(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(Wo(t,t.next)||sn(t.prev,t,t.next)===0)){if(al(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function rl(i,e,t,n,s,r,o){if(!i)return;!o&&r&&J1(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?G1(i,n,s,r):V1(i)){e.push(l.i,i.i,c.i),al(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=W1(Vr(i),e),rl(i,e,t,n,s,r,2)):o===2&&X1(i,e,t,n,s,r):rl(Vr(i),e,t,n,s,r,1);break}}}function V1(i){let e=i.prev,t=i,n=i.next;if(sn(e,t,n)>=0)return!1;let s=e.x,r=t.x,o=n.x,a=e.y,l=t.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),f=Math.max(s,r,o),d=Math.max(a,l,c),p=n.next;for(;p!==e;){if(p.x>=h&&p.x<=f&&p.y>=u&&p.y<=d&&Ua(s,a,r,l,o,c,p.x,p.y)&&sn(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function G1(i,e,t,n){let s=i.prev,r=i,o=i.next;if(sn(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,f=o.y,d=Math.min(a,l,c),p=Math.min(h,u,f),x=Math.max(a,l,c),m=Math.max(h,u,f),g=wd(d,p,e,t,n),b=wd(x,m,e,t,n),M=i.prevZ,y=i.nextZ;for(;M&&M.z>=g&&y&&y.z<=b;){if(M.x>=d&&M.x<=x&&M.y>=p&&M.y<=m&&M!==s&&M!==o&&Ua(a,h,l,u,c,f,M.x,M.y)&&sn(M.prev,M,M.next)>=0||(M=M.prevZ,y.x>=d&&y.x<=x&&y.y>=p&&y.y<=m&&y!==s&&y!==o&&Ua(a,h,l,u,c,f,y.x,y.y)&&sn(y.prev,y,y.next)>=0))return!1;y=y.nextZ}for(;M&&M.z>=g;){if(M.x>=d&&M.x<=x&&M.y>=p&&M.y<=m&&M!==s&&M!==o&&Ua(a,h,l,u,c,f,M.x,M.y)&&sn(M.prev,M,M.next)>=0)return!1;M=M.prevZ}for(;y&&y.z<=b;){if(y.x>=d&&y.x<=x&&y.y>=p&&y.y<=m&&y!==s&&y!==o&&Ua(a,h,l,u,c,f,y.x,y.y)&&sn(y.prev,y,y.next)>=0)return!1;y=y.nextZ}return!0}function W1(i,e){let t=i;do{let n=t.prev,s=t.next.next;!Wo(n,s)&&Mx(n,t,t.next,s)&&ol(n,s)&&ol(s,n)&&(e.push(n.i,t.i,s.i),al(t),al(t.next),t=i=s),t=t.next}while(t!==i);return Vr(t)}function X1(i,e,t,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&eM(o,a)){let l=wx(o,a);o=Vr(o,o.next),l=Vr(l,l.next),rl(o,e,t,n,s,r,0),rl(l,e,t,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function q1(i,e,t,n){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*n,l=r<o-1?e[r+1]*n:i.length,c=yx(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(Q1(c))}s.sort($1);for(let r=0;r<s.length;r++)t=Y1(s[r],t);return t}function $1(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function Y1(i,e){let t=Z1(i,e);if(!t)return e;let n=wx(t,i);return Vr(n,n.next),Vr(t,t.next)}function Z1(i,e){let t=e,n=i.x,s=i.y,r=-1/0,o;if(Wo(i,t))return t;do{if(Wo(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let u=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(u<=n&&u>r&&(r=u,o=t.x<t.next.x?t:t.next,u===n))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;t=o;do{if(n>=t.x&&t.x>=l&&n!==t.x&&_x(s<c?n:r,s,l,c,s<c?r:n,s,t.x,t.y)){let u=Math.abs(s-t.y)/(n-t.x);ol(t,i)&&(u<h||u===h&&(t.x>o.x||t.x===o.x&&j1(o,t)))&&(o=t,h=u)}t=t.next}while(t!==a);return o}function j1(i,e){return sn(i.prev,i,e.prev)<0&&sn(e.next,i,i.next)<0}function J1(i,e,t,n){let s=i;do s.z===0&&(s.z=wd(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,K1(s)}function K1(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let o=n,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,t*=2}while(e>1);return i}function wd(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function Q1(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function _x(i,e,t,n,s,r,o,a){return(s-o)*(e-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(n-a)}function Ua(i,e,t,n,s,r,o,a){return!(i===o&&e===a)&&_x(i,e,t,n,s,r,o,a)}function eM(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!tM(i,e)&&(ol(i,e)&&ol(e,i)&&nM(i,e)&&(sn(i.prev,i,e.prev)||sn(i,e.prev,e))||Wo(i,e)&&sn(i.prev,i,i.next)>0&&sn(e.prev,e,e.next)>0)}function sn(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function Wo(i,e){return i.x===e.x&&i.y===e.y}function Mx(i,e,t,n){let s=Cc(sn(i,e,t)),r=Cc(sn(i,e,n)),o=Cc(sn(t,n,i)),a=Cc(sn(t,n,e));return!!(s!==r&&o!==a||s===0&&Rc(i,t,e)||r===0&&Rc(i,n,e)||o===0&&Rc(t,i,n)||a===0&&Rc(t,e,n))}function Rc(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function Cc(i){return i>0?1:i<0?-1:0}function tM(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&Mx(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function ol(i,e){return sn(i.prev,i,i.next)<0?sn(i,e,i.next)>=0&&sn(i,i.prev,e)>=0:sn(i,e,i.prev)<0||sn(i,i.next,e)<0}function nM(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function wx(i,e){let t=Sd(i.i,i.x,i.y),n=Sd(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function M0(i,e,t,n){let s=Sd(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function al(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function Sd(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function iM(i,e,t,n){let s=0;for(let r=e,o=t-n;r<t;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var Ed=class{static triangulate(e,t,n=2){return H1(e,t,n)}},bs=class i{static area(e){let t=e.length,n=0;for(let s=t-1,r=0;r<t;s=r++)n+=e[s].x*e[r].y-e[r].x*e[s].y;return n*.5}static isClockWise(e){return i.area(e)<0}static triangulateShape(e,t){let n=[],s=[],r=[];w0(e),S0(n,e);let o=e.length;t.forEach(w0);for(let l=0;l<t.length;l++)s.push(o),o+=t[l].length,S0(n,t[l]);let a=Ed.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function w0(i){let e=i.length;e>2&&i[e-1].equals(i[0])&&i.pop()}function S0(i,e){for(let t=0;t<e.length;t++)i.push(e[t].x),i.push(e[t].y)}var ll=class i extends Jc{constructor(e=1,t=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new i(e.radius,e.detail)}},cl=class i extends vt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,f=t/l,d=[],p=[],x=[],m=[];for(let g=0;g<h;g++){let b=g*f-o;for(let M=0;M<c;M++){let y=M*u-r;p.push(y,-b,0),x.push(0,0,1),m.push(M/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let b=0;b<a;b++){let M=b+c*g,y=b+c*(g+1),R=b+1+c*(g+1),S=b+1+c*g;d.push(M,y,S),d.push(y,R,S)}this.setIndex(d),this.setAttribute("position",new rt(p,3)),this.setAttribute("normal",new rt(x,3)),this.setAttribute("uv",new rt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var hl=class i extends vt{constructor(e=new Go([new we(0,.5),new we(-.5,-.5),new we(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let n=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let h=0;h<e.length;h++)c(e[h]),this.addGroup(a,l,h),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new rt(s,3)),this.setAttribute("normal",new rt(r,3)),this.setAttribute("uv",new rt(o,2));function c(h){let u=s.length/3,f=h.extractPoints(t),d=f.shape,p=f.holes;bs.isClockWise(d)===!1&&(d=d.reverse());for(let m=0,g=p.length;m<g;m++){let b=p[m];bs.isClockWise(b)===!0&&(p[m]=b.reverse())}let x=bs.triangulateShape(d,p);for(let m=0,g=p.length;m<g;m++){let b=p[m];d=d.concat(b)}for(let m=0,g=d.length;m<g;m++){let b=d[m];s.push(b.x,b.y,0),r.push(0,0,1),o.push(b.x,b.y)}for(let m=0,g=x.length;m<g;m++){let b=x[m],M=b[0]+u,y=b[1]+u,R=b[2]+u;n.push(M,y,R),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return sM(t,e)}static fromJSON(e,t){let n=[];for(let s=0,r=e.shapes.length;s<r;s++){let o=t[e.shapes[s]];n.push(o)}return new i(n,e.curveSegments)}};function sM(i,e){if(e.shapes=[],Array.isArray(i))for(let t=0,n=i.length;t<n;t++){let s=i[t];e.shapes.push(s.uuid)}else e.shapes.push(i.uuid);return e}function $r(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(E0(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(E0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Kn(i){let e={};for(let t=0;t<i.length;t++){let n=$r(i[t]);for(let s in n)e[s]=n[s]}return e}function E0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function rM(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function rp(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:bt.workingColorSpace}var Sx={clone:$r,merge:Kn},oM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,aM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Hi=class extends vs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=oM,this.fragmentShader=aM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=$r(e.uniforms),this.uniformsGroups=rM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new qe().setHex(s.value);break;case"v2":this.uniforms[n].value=new we().fromArray(s.value);break;case"v3":this.uniforms[n].value=new N().fromArray(s.value);break;case"v4":this.uniforms[n].value=new en().fromArray(s.value);break;case"m3":this.uniforms[n].value=new it().fromArray(s.value);break;case"m4":this.uniforms[n].value=new wt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},ih=class extends Hi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var _s=class extends vs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ru,this.normalScale=new we(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Vs,this.combine=bh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},sh=class extends vs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=sx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},rh=class extends vs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Po(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Pc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var br=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},oh=class extends br{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:vd,endingEnd:vd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case yd:r=e,a=2*t-n;break;case _d:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case yd:o=e,l=2*n-t;break;case _d:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,p=(n-t)/(s-t),x=p*p,m=x*p,g=-f*m+2*f*x-f*p,b=(1+f)*m+(-1.5-2*f)*x+(-.5+f)*p+1,M=(-1-d)*m+(1.5+d)*x+.5*p,y=d*m-d*x;for(let R=0;R!==a;++R)r[R]=g*o[h+R]+b*o[c+R]+M*o[l+R]+y*o[u+R];return r}},ah=class extends br{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},lh=class extends br{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ch=class extends br{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let f=a*2,d=e-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=d*f+p*2,b=u[g],M=u[g+1],y=e*f+p*2,R=h[y],S=h[y+1],v=cM(n,t,b,R,s);r[p]=Ex(v,x,M,S,m)}return r}};function Ex(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function lM(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function cM(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=Ex(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=lM(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ai=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Po(t,this.TimeBufferType),this.values=Po(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Po(e.times,Array),values:Po(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Pc(e.settings)&&(n.settings={inTangents:Po(e.settings.inTangents,Array),outTangents:Po(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new lh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ah(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new oh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ch(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ha:t=this.InterpolantFactoryMethodDiscrete;break;case Wc:t=this.InterpolantFactoryMethodLinear;break;case Dc:t=this.InterpolantFactoryMethodSmooth;break;case bd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ye("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ha;case this.InterpolantFactoryMethodLinear:return Wc;case this.InterpolantFactoryMethodSmooth:return Dc;case this.InterpolantFactoryMethodBezier:return bd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Pc(this.settings)&&(T0(this.settings.inTangents,e),T0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Pc(this.settings)&&(A0(this.settings.inTangents,e),A0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(et("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(et("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){et("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){et("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Q_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){et("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Dc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,f=u-n,d=u+n;for(let p=0;p!==n;++p){let x=t[u+p];if(x!==t[f+p]||x!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,f=o*n;for(let d=0;d!==n;++d)t[f+d]=t[u+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Pc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function T0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function A0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Ai.prototype.ValueTypeName="";Ai.prototype.TimeBufferType=Float32Array;Ai.prototype.ValueBufferType=Float32Array;Ai.prototype.DefaultInterpolation=Wc;var vr=class extends Ai{constructor(e,t,n){super(e,t,n)}};vr.prototype.ValueTypeName="bool";vr.prototype.ValueBufferType=Array;vr.prototype.DefaultInterpolation=Ha;vr.prototype.InterpolantFactoryMethodLinear=void 0;vr.prototype.InterpolantFactoryMethodSmooth=void 0;var hh=class extends Ai{constructor(e,t,n,s){super(e,t,n,s)}};hh.prototype.ValueTypeName="color";var uh=class extends Ai{constructor(e,t,n,s){super(e,t,n,s)}};uh.prototype.ValueTypeName="number";var fh=class extends br{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Ei.slerpFlat(r,0,o,c-a,o,c,l);return r}},ul=class extends Ai{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new fh(this.times,this.values,this.getValueSize(),e)}};ul.prototype.ValueTypeName="quaternion";ul.prototype.InterpolantFactoryMethodSmooth=void 0;var yr=class extends Ai{constructor(e,t,n){super(e,t,n)}};yr.prototype.ValueTypeName="string";yr.prototype.ValueBufferType=Array;yr.prototype.DefaultInterpolation=Ha;yr.prototype.InterpolantFactoryMethodLinear=void 0;yr.prototype.InterpolantFactoryMethodSmooth=void 0;var dh=class extends Ai{constructor(e,t,n,s){super(e,t,n,s)}};dh.prototype.ValueTypeName="vector";var ph=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],p=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Tx=new ph,mh=class{constructor(e){this.manager=e!==void 0?e:Tx,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};mh.DEFAULT_MATERIAL_NAME="__DEFAULT";var fl=class extends tn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new qe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},dl=class extends fl{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(tn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new qe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},xd=new wt,R0=new N,C0=new N,gh=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new we(512,512),this.mapType=di,this.map=null,this.mapPass=null,this.matrix=new wt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new gr,this._frameExtents=new we(1,1),this._viewportCount=1,this._viewports=[new en(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;R0.setFromMatrixPosition(e.matrixWorld),t.position.copy(R0),C0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(C0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){xd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(xd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Uo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(xd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Ic=new N,Lc=new Ei,gs=new N,pl=class extends tn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new wt,this.projectionMatrix=new wt,this.projectionMatrixInverse=new wt,this.coordinateSystem=ki,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ic,Lc,gs),gs.x===1&&gs.y===1&&gs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ic,Lc,gs.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Ic,Lc,gs),gs.x===1&&gs.y===1&&gs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ic,Lc,gs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},pr=new N,P0=new we,I0=new we,pn=class extends pl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Oo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Oa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Oo*2*Math.atan(Math.tan(Oa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){pr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(pr.x,pr.y).multiplyScalar(-e/pr.z),pr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(pr.x,pr.y).multiplyScalar(-e/pr.z)}getViewSize(e,t){return this.getViewBounds(e,P0,I0),t.subVectors(I0,P0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Oa*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ri=class extends pl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Td=class extends gh{constructor(){super(new Ri(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ml=class extends fl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(tn.DEFAULT_UP),this.updateMatrix(),this.target=new tn,this.shadow=new Td}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Io=-90,Lo=1,Xo=class extends tn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new pn(Io,Lo,e,t);s.layers=this.layers,this.add(s);let r=new pn(Io,Lo,e,t);r.layers=this.layers,this.add(r);let o=new pn(Io,Lo,e,t);o.layers=this.layers,this.add(o);let a=new pn(Io,Lo,e,t);a.layers=this.layers,this.add(a);let l=new pn(Io,Lo,e,t);l.layers=this.layers,this.add(l);let c=new pn(Io,Lo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===ki)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Uo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=x,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,f,d),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},xh=class extends pn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var op="\\[\\]\\.:\\/",hM=new RegExp("["+op+"]","g"),ap="[^"+op+"]",uM="[^"+op.replace("\\.","")+"]",fM=/((?:WC+[\/:])*)/.source.replace("WC",ap),dM=/(WCOD+)?/.source.replace("WCOD",uM),pM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",ap),mM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",ap),gM=new RegExp("^"+fM+dM+pM+mM+"$"),xM=["material","materials","bones","map"],Ad=class{constructor(e,t,n){let s=n||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Zt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(hM,"")}static parseTrackName(e){let t=gM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);xM.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){et("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){et("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){et("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){et("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){et("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;et("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=Ad;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var gP=new Float32Array(1);var L0=new wt,gl=class{constructor(e,t,n=0,s=1/0){this.ray=new Gs(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Bo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):et("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return L0.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(L0),this}intersectObject(e,t=!0,n=[]){return Rd(e,this,n,t),n.sort(D0),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Rd(e[s],this,n,t);return n.sort(D0),n}};function D0(i,e){return i.distance-e.distance}function Rd(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Rd(r[o],e,t,!0)}}var qo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ft(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(ft(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Cd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var xl=class extends Qi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function lp(i,e,t,n){let s=bM(n);switch(t){case Yd:return i*e;case Eh:return i*e/s.components*s.byteLength;case Th:return i*e/s.components*s.byteLength;case _r:return i*e*2/s.components*s.byteLength;case Ah:return i*e*2/s.components*s.byteLength;case Zd:return i*e*3/s.components*s.byteLength;case is:return i*e*4/s.components*s.byteLength;case Rh:return i*e*4/s.components*s.byteLength;case yl:case _l:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ml:case wl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ph:case Lh:return Math.max(i,16)*Math.max(e,8)/4;case Ch:case Ih:return Math.max(i,8)*Math.max(e,8)/2;case Dh:case Nh:case Fh:case Oh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Uh:case Sl:case kh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Bh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case zh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Hh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Vh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Gh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Wh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Xh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case qh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case $h:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Yh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Zh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case jh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Jh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Kh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Qh:case eu:case tu:return Math.ceil(i/4)*Math.ceil(e/4)*16;case nu:case iu:return Math.ceil(i/4)*Math.ceil(e/4)*8;case El:case su:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function bM(i){switch(i){case di:case Wd:return{byteLength:1,components:1};case jo:case Xd:case ns:return{byteLength:2,components:1};case wh:case Sh:return{byteLength:2,components:4};case Ci:case Mh:case Gi:return{byteLength:4,components:1};case qd:case $d:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Yx(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function yM(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((d,p)=>d.start-p.start);let f=0;for(let d=1;d<u.length;d++){let p=u[f],x=u[d];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++f,u[f]=x)}u.length=f+1;for(let d=0,p=u.length;d<p;d++){let x=u[d];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var _M=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,MM=`#ifdef USE_ALPHAHASH
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
#endif`,wM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,SM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,EM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,TM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,AM=`#ifdef USE_AOMAP
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
#endif`,RM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,CM=`#ifdef USE_BATCHING
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
#endif`,PM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,IM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,LM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,DM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,NM=`#ifdef USE_IRIDESCENCE
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
#endif`,UM=`#ifdef USE_BUMPMAP
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
#endif`,FM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,OM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,kM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,BM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,zM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,HM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,VM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,GM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,WM=`#define PI 3.141592653589793
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
} // validated`,XM=`vec3 transformedNormal = objectNormal;
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
#endif`,qM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,$M=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,YM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ZM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,jM="gl_FragColor = linearToOutputTexel( gl_FragColor );",JM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,KM=`#ifdef USE_ENVMAP
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
#endif`,QM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ew=`#ifdef USE_ENVMAP
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
#endif`,tw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,nw=`#ifdef USE_ENVMAP
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
#endif`,iw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,sw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,rw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ow=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,aw=`#ifdef USE_GRADIENTMAP
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
}`,lw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,cw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,hw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,uw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,fw=`#ifdef USE_ENVMAP
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
#endif`,dw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,pw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,mw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,gw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,xw=`PhysicalMaterial material;
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
#endif`,bw=`uniform sampler2D dfgLUT;
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
}`,vw=`
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
#endif`,yw=`#if defined( RE_IndirectDiffuse )
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
#endif`,_w=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Mw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,ww=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Sw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ew=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Tw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Aw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Rw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Cw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Pw=`#if defined( USE_POINTS_UV )
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
#endif`,Iw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Lw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Dw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Nw=`#if defined( USE_MORPHCOLORS )
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
#endif`,Uw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Fw=`#ifdef USE_MORPHTARGETS
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
#endif`,Ow=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,kw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Bw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,zw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Hw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Vw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Gw=`#ifdef USE_NORMALMAP
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
#endif`,Ww=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Xw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,qw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,$w=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Yw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Zw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,jw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Jw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Kw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Qw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,eS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,tS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,nS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,iS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,sS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,rS=`float getShadowMask() {
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
}`,oS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,aS=`#ifdef USE_SKINNING
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
#endif`,lS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,cS=`#ifdef USE_SKINNING
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
#endif`,hS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,uS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,fS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,dS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,pS=`#ifdef USE_TRANSMISSION
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
#endif`,mS=`#ifdef USE_TRANSMISSION
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
#endif`,gS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,xS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,bS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,vS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,yS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,_S=`uniform sampler2D t2D;
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
}`,MS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wS=`uniform float backgroundBlurriness;
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
}`,SS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ES=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,TS=`#include <common>
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
}`,AS=`#if DEPTH_PACKING == 3200
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
}`,RS=`#define DISTANCE
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
}`,CS=`#define DISTANCE
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
}`,PS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,IS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,LS=`uniform float scale;
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
}`,DS=`uniform vec3 diffuse;
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
}`,NS=`#include <common>
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
}`,US=`uniform vec3 diffuse;
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
}`,FS=`#define LAMBERT
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
}`,OS=`#define LAMBERT
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
}`,kS=`#define MATCAP
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
}`,BS=`#define MATCAP
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
}`,zS=`#define NORMAL
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
}`,HS=`#define NORMAL
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
}`,VS=`#define PHONG
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
}`,GS=`#define PHONG
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
}`,WS=`#define STANDARD
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
}`,XS=`#define STANDARD
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
}`,qS=`#define TOON
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
}`,$S=`#define TOON
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
}`,YS=`uniform float size;
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
}`,ZS=`uniform vec3 diffuse;
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
}`,jS=`#include <common>
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
}`,JS=`uniform vec3 color;
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
}`,KS=`uniform float rotation;
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
}`,QS=`uniform vec3 diffuse;
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
}`,dt={alphahash_fragment:_M,alphahash_pars_fragment:MM,alphamap_fragment:wM,alphamap_pars_fragment:SM,alphatest_fragment:EM,alphatest_pars_fragment:TM,aomap_fragment:AM,aomap_pars_fragment:RM,batching_pars_vertex:CM,batching_vertex:PM,begin_vertex:IM,beginnormal_vertex:LM,bsdfs:DM,iridescence_fragment:NM,bumpmap_pars_fragment:UM,clipping_planes_fragment:FM,clipping_planes_pars_fragment:OM,clipping_planes_pars_vertex:kM,clipping_planes_vertex:BM,color_fragment:zM,color_pars_fragment:HM,color_pars_vertex:VM,color_vertex:GM,common:WM,defaultnormal_vertex:XM,displacementmap_pars_vertex:qM,displacementmap_vertex:$M,emissivemap_fragment:YM,emissivemap_pars_fragment:ZM,colorspace_fragment:jM,colorspace_pars_fragment:JM,envmap_fragment:KM,envmap_common_pars_fragment:QM,envmap_pars_fragment:ew,envmap_pars_vertex:tw,envmap_physical_pars_fragment:fw,envmap_vertex:nw,fog_vertex:iw,fog_pars_vertex:sw,fog_fragment:rw,fog_pars_fragment:ow,gradientmap_pars_fragment:aw,lightmap_pars_fragment:lw,lights_lambert_fragment:cw,lights_lambert_pars_fragment:hw,lights_pars_begin:uw,lights_toon_fragment:dw,lights_toon_pars_fragment:pw,lights_phong_fragment:mw,lights_phong_pars_fragment:gw,lights_physical_fragment:xw,lights_physical_pars_fragment:bw,lights_fragment_begin:vw,lights_fragment_maps:yw,lights_fragment_end:_w,lightprobes_pars_fragment:Mw,logdepthbuf_fragment:ww,logdepthbuf_pars_fragment:Sw,logdepthbuf_pars_vertex:Ew,logdepthbuf_vertex:Tw,map_fragment:Aw,map_pars_fragment:Rw,map_particle_fragment:Cw,map_particle_pars_fragment:Pw,metalnessmap_fragment:Iw,metalnessmap_pars_fragment:Lw,morphinstance_vertex:Dw,morphcolor_vertex:Nw,morphnormal_vertex:Uw,morphtarget_pars_vertex:Fw,morphtarget_vertex:Ow,normal_fragment_begin:kw,normal_fragment_maps:Bw,normal_pars_fragment:zw,normal_pars_vertex:Hw,normal_vertex:Vw,normalmap_pars_fragment:Gw,clearcoat_normal_fragment_begin:Ww,clearcoat_normal_fragment_maps:Xw,clearcoat_pars_fragment:qw,iridescence_pars_fragment:$w,opaque_fragment:Yw,packing:Zw,premultiplied_alpha_fragment:jw,project_vertex:Jw,dithering_fragment:Kw,dithering_pars_fragment:Qw,roughnessmap_fragment:eS,roughnessmap_pars_fragment:tS,shadowmap_pars_fragment:nS,shadowmap_pars_vertex:iS,shadowmap_vertex:sS,shadowmask_pars_fragment:rS,skinbase_vertex:oS,skinning_pars_vertex:aS,skinning_vertex:lS,skinnormal_vertex:cS,specularmap_fragment:hS,specularmap_pars_fragment:uS,tonemapping_fragment:fS,tonemapping_pars_fragment:dS,transmission_fragment:pS,transmission_pars_fragment:mS,uv_pars_fragment:gS,uv_pars_vertex:xS,uv_vertex:bS,worldpos_vertex:vS,background_vert:yS,background_frag:_S,backgroundCube_vert:MS,backgroundCube_frag:wS,cube_vert:SS,cube_frag:ES,depth_vert:TS,depth_frag:AS,distance_vert:RS,distance_frag:CS,equirect_vert:PS,equirect_frag:IS,linedashed_vert:LS,linedashed_frag:DS,meshbasic_vert:NS,meshbasic_frag:US,meshlambert_vert:FS,meshlambert_frag:OS,meshmatcap_vert:kS,meshmatcap_frag:BS,meshnormal_vert:zS,meshnormal_frag:HS,meshphong_vert:VS,meshphong_frag:GS,meshphysical_vert:WS,meshphysical_frag:XS,meshtoon_vert:qS,meshtoon_frag:$S,points_vert:YS,points_frag:ZS,shadow_vert:jS,shadow_frag:JS,sprite_vert:KS,sprite_frag:QS},De={common:{diffuse:{value:new qe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new we(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new qe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new qe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new qe(16777215)},opacity:{value:1},center:{value:new we(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},Es={basic:{uniforms:Kn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:dt.meshbasic_vert,fragmentShader:dt.meshbasic_frag},lambert:{uniforms:Kn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new qe(0)},envMapIntensity:{value:1}}]),vertexShader:dt.meshlambert_vert,fragmentShader:dt.meshlambert_frag},phong:{uniforms:Kn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new qe(0)},specular:{value:new qe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:dt.meshphong_vert,fragmentShader:dt.meshphong_frag},standard:{uniforms:Kn([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new qe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag},toon:{uniforms:Kn([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new qe(0)}}]),vertexShader:dt.meshtoon_vert,fragmentShader:dt.meshtoon_frag},matcap:{uniforms:Kn([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:dt.meshmatcap_vert,fragmentShader:dt.meshmatcap_frag},points:{uniforms:Kn([De.points,De.fog]),vertexShader:dt.points_vert,fragmentShader:dt.points_frag},dashed:{uniforms:Kn([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:dt.linedashed_vert,fragmentShader:dt.linedashed_frag},depth:{uniforms:Kn([De.common,De.displacementmap]),vertexShader:dt.depth_vert,fragmentShader:dt.depth_frag},normal:{uniforms:Kn([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:dt.meshnormal_vert,fragmentShader:dt.meshnormal_frag},sprite:{uniforms:Kn([De.sprite,De.fog]),vertexShader:dt.sprite_vert,fragmentShader:dt.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:dt.background_vert,fragmentShader:dt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:dt.backgroundCube_vert,fragmentShader:dt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:dt.cube_vert,fragmentShader:dt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:dt.equirect_vert,fragmentShader:dt.equirect_frag},distance:{uniforms:Kn([De.common,De.displacementmap,{referencePosition:{value:new N},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:dt.distance_vert,fragmentShader:dt.distance_frag},shadow:{uniforms:Kn([De.lights,De.fog,{color:{value:new qe(0)},opacity:{value:1}}]),vertexShader:dt.shadow_vert,fragmentShader:dt.shadow_frag}};Es.physical={uniforms:Kn([Es.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new we(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new qe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new we},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new qe(0)},specularColor:{value:new qe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new we},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag};var ou={r:0,b:0,g:0},eE=new wt,Zx=new it;Zx.set(-1,0,0,0,1,0,0,0,1);function tE(i,e,t,n,s,r){let o=new qe(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(b){let M=b.isScene===!0?b.background:null;if(M&&M.isTexture){let y=b.backgroundBlurriness>0;M=e.get(M,y)}return M}function p(b){let M=!1,y=d(b);y===null?m(o,a):y&&y.isColor&&(m(y,1),M=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(b,M){let y=d(M);y&&y.isCubeTexture?(c===void 0&&(c=new Ot(new xr(1,1,1),new Hi({name:"BackgroundCubeMaterial",uniforms:$r(Es.backgroundCube.uniforms),vertexShader:Es.backgroundCube.vertexShader,fragmentShader:Es.backgroundCube.fragmentShader,side:li,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,S,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(eE.makeRotationFromEuler(M.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Zx),c.material.toneMapped=bt.getTransfer(y.colorSpace)!==Pt,(h!==y||u!==y.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=y,u=y.version,f=i.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new Ot(new cl(2,2),new Hi({name:"BackgroundMaterial",uniforms:$r(Es.background.uniforms),vertexShader:Es.background.vertexShader,fragmentShader:Es.background.fragmentShader,side:Ms,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=bt.getTransfer(y.colorSpace)!==Pt,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(h!==y||u!==y.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=y,u=y.version,f=i.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function m(b,M){b.getRGB(ou,rp(i)),t.buffers.color.setClear(ou.r,ou.g,ou.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,M=1){o.set(b),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,m(o,a)},render:p,addToRenderList:x,dispose:g}}function nE(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(I,O,z,U,G){let q=!1,H=u(I,U,z,O);r!==H&&(r=H,c(r.object)),q=d(I,U,z,G),q&&p(I,U,z,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,y(I,O,z,U),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(I){return i.bindVertexArray(I)}function h(I){return i.deleteVertexArray(I)}function u(I,O,z,U){let G=U.wireframe===!0,q=n[O.id];q===void 0&&(q={},n[O.id]=q);let H=I.isInstancedMesh===!0?I.id:0,ae=q[H];ae===void 0&&(ae={},q[H]=ae);let Y=ae[z.id];Y===void 0&&(Y={},ae[z.id]=Y);let ee=Y[G];return ee===void 0&&(ee=f(l()),Y[G]=ee),ee}function f(I){let O=[],z=[],U=[];for(let G=0;G<t;G++)O[G]=0,z[G]=0,U[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:z,attributeDivisors:U,object:I,attributes:{},index:null}}function d(I,O,z,U){let G=r.attributes,q=O.attributes,H=0,ae=z.getAttributes();for(let Y in ae)if(ae[Y].location>=0){let te=G[Y],de=q[Y];if(de===void 0&&(Y==="instanceMatrix"&&I.instanceMatrix&&(de=I.instanceMatrix),Y==="instanceColor"&&I.instanceColor&&(de=I.instanceColor)),te===void 0||te.attribute!==de||de&&te.data!==de.data)return!0;H++}return r.attributesNum!==H||r.index!==U}function p(I,O,z,U){let G={},q=O.attributes,H=0,ae=z.getAttributes();for(let Y in ae)if(ae[Y].location>=0){let te=q[Y];te===void 0&&(Y==="instanceMatrix"&&I.instanceMatrix&&(te=I.instanceMatrix),Y==="instanceColor"&&I.instanceColor&&(te=I.instanceColor));let de={};de.attribute=te,te&&te.data&&(de.data=te.data),G[Y]=de,H++}r.attributes=G,r.attributesNum=H,r.index=U}function x(){let I=r.newAttributes;for(let O=0,z=I.length;O<z;O++)I[O]=0}function m(I){g(I,0)}function g(I,O){let z=r.newAttributes,U=r.enabledAttributes,G=r.attributeDivisors;z[I]=1,U[I]===0&&(i.enableVertexAttribArray(I),U[I]=1),G[I]!==O&&(i.vertexAttribDivisor(I,O),G[I]=O)}function b(){let I=r.newAttributes,O=r.enabledAttributes;for(let z=0,U=O.length;z<U;z++)O[z]!==I[z]&&(i.disableVertexAttribArray(z),O[z]=0)}function M(I,O,z,U,G,q,H){H===!0?i.vertexAttribIPointer(I,O,z,G,q):i.vertexAttribPointer(I,O,z,U,G,q)}function y(I,O,z,U){x();let G=U.attributes,q=z.getAttributes(),H=O.defaultAttributeValues;for(let ae in q){let Y=q[ae];if(Y.location>=0){let ee=G[ae];if(ee===void 0&&(ae==="instanceMatrix"&&I.instanceMatrix&&(ee=I.instanceMatrix),ae==="instanceColor"&&I.instanceColor&&(ee=I.instanceColor)),ee!==void 0){let te=ee.normalized,de=ee.itemSize,ce=e.get(ee);if(ce===void 0)continue;let J=ce.buffer,ue=ce.type,ge=ce.bytesPerElement,Se=ue===i.INT||ue===i.UNSIGNED_INT||ee.gpuType===Mh;if(ee.isInterleavedBufferAttribute){let be=ee.data,Ge=be.isInterleavedBuffer===!0?be.stride:be.itemSize,tt=ee.offset;if(be.isInstancedInterleavedBuffer||be.isInstancedBufferAttribute){for(let He=0;He<Y.locationSize;He++)g(Y.location+He,be.meshPerAttribute);I.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=be.meshPerAttribute*be.count)}else for(let He=0;He<Y.locationSize;He++)m(Y.location+He);i.bindBuffer(i.ARRAY_BUFFER,J);for(let He=0;He<Y.locationSize;He++)M(Y.location+He,de/Y.locationSize,ue,te,Ge*ge,(tt+de/Y.locationSize*He)*ge,Se)}else{if(ee.isInstancedBufferAttribute){for(let be=0;be<Y.locationSize;be++)g(Y.location+be,ee.meshPerAttribute);I.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let be=0;be<Y.locationSize;be++)m(Y.location+be);i.bindBuffer(i.ARRAY_BUFFER,J);for(let be=0;be<Y.locationSize;be++)M(Y.location+be,de/Y.locationSize,ue,te,de*ge,de/Y.locationSize*be*ge,Se)}}else if(H!==void 0){let te=H[ae];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(Y.location,te);break;case 3:i.vertexAttrib3fv(Y.location,te);break;case 4:i.vertexAttrib4fv(Y.location,te);break;default:i.vertexAttrib1fv(Y.location,te)}}}}b()}function R(){C();for(let I in n){let O=n[I];for(let z in O){let U=O[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete n[I]}}function S(I){if(n[I.id]===void 0)return;let O=n[I.id];for(let z in O){let U=O[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete n[I.id]}function v(I){for(let O in n){let z=n[O];for(let U in z){let G=z[U];if(G[I.id]===void 0)continue;let q=G[I.id];for(let H in q)h(q[H].object),delete q[H];delete G[I.id]}}}function w(I){for(let O in n){let z=n[O],U=I.isInstancedMesh===!0?I.id:0,G=z[U];if(G!==void 0){for(let q in G){let H=G[q];for(let ae in H)h(H[ae].object),delete H[ae];delete G[q]}delete z[U],Object.keys(z).length===0&&delete n[O]}}}function C(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:C,resetDefaultState:P,dispose:R,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:m,disableUnusedAttributes:b}}function iE(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];t.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function sE(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==is&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let w=v===ns&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==di&&v!==Gi&&!w&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ye("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),S=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:b,maxVaryings:M,maxFragmentUniforms:y,maxSamples:R,samples:S}}function rE(i){let e=this,t=null,n=0,s=!1,r=!1,o=new oi,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){t=h(u,f,0)},this.setState=function(u,f,d){let p=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let b=r?0:n,M=b*4,y=g.clippingState||null;l.value=y,y=h(p,f,M,d);for(let R=0;R!==M;++R)y[R]=t[R];g.clippingState=y,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,f,d,p){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=d+x*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(m===null||m.length<g)&&(m=new Float32Array(g));for(let M=0,y=d;M!==x;++M,y+=4)o.copy(u[M]).applyMatrix4(b,a),o.normal.toArray(m,y),m[y+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}var Cl=class extends Xn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ja(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new xr(5,5,5),r=new Hi({name:"CubemapFromEquirect",uniforms:$r(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:li,blending:Zs});r.uniforms.tEquirect.value=t;let o=new Ot(s,r),a=t.minFilter;return t.minFilter===js&&(t.minFilter=ai),new Xo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Ax=256,oE=3,aE=20,jx=256,Jx=16,lE=3,cE=new N,hE=new qe,lu=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Xo(1,10,null),this._boxMesh=new Ot(new xr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=cE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(hE));let m=new Xo(n,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=p,e.background=x,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Px(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Cx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Ax,np(e))}_fromTexture(e,t){e.mapping===Wr||e.mapping===Zo?this._setSize(e.image.length===0?Ax:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Rx(e,!1,!1),n=Math.log2(e)-oE;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Rx(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Wr||e.mapping===Zo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Px()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Cx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=uE(),this._integrationMaterial=fE());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Jx);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-lE)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(jx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=dE());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Rx(i,e,t){return new Cl(i,{minFilter:js,generateMipmaps:e,type:ns,colorSpace:Va,depthBuffer:t})}function Pl(i,e,t){return new Hi({name:i,uniforms:e,vertexShader:dt.cube_vert,fragmentShader:t,side:li,blending:Zs,depthTest:!1,depthWrite:!1})}function uE(){return Pl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${jx}u

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
	`)}function fE(){return Pl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Jx}},`

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
	`)}function dE(){return Pl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${aE}
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
	`)}function Cx(){return Pl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Px(){return Pl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function pE(i){let e=new WeakMap,t=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===vh||d===yh)if(e.has(f)){let p=e.get(f).texture;return a(p,f.mapping)}else{let p=f.image;if(p&&p.height>0){let x=new Cl(p.height);return x.fromEquirectangularTexture(i,f),e.set(f,x),f.addEventListener("dispose",c),a(x.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,p=d===vh||d===yh,x=d===Wr||d===Zo;if(p||x){let m=t.get(f),g=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return n===null&&(n=new lu(i)),m=p?n.fromEquirectangular(f,m):n.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),m.texture;if(m!==void 0)return m.texture;{let b=f.image;return p&&b&&b.height>0||x&&b&&l(b)?(n===null&&(n=new lu(i)),m=p?n.fromEquirectangular(f):n.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),f.addEventListener("dispose",h),m.texture):null}}}return f}function a(f,d){return d===vh?f.mapping=Wr:d===yh&&(f.mapping=Zo),f}function l(f){let d=0,p=6;for(let x=0;x<p;x++)f[x]!==void 0&&d++;return d===p}function c(f){let d=f.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function mE(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Fa("WebGLRenderer: "+n+" extension not supported."),s}}}function gE(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(e.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function h(p){let x=p.attributes;for(let m in x)e.update(x[m],i.ARRAY_BUFFER)}function u(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let b=x!==null?x.array.length:m.array.length/3-1,M=m.count>=65535?Ya:$a,y=new M(Math.ceil(b/3)*6,1),R=y.array;if(x!==null){let v=x.array;g=x.version;for(let w=0,C=0;w<b;w+=3){let P=v[w+0],I=v[w+1],O=v[w+2];R[C++]=P,R[C++]=I,R[C++]=I,R[C++]=O,R[C++]=O,R[C++]=P}}else{g=m.version;for(let v=0,w=0;v<b;v+=3){let C=v+0,P=v+1,I=v+2;R[w++]=C,R[w++]=P,R[w++]=P,R[w++]=I,R[w++]=I,R[w++]=C}}y.version=g;let S=r.get(p);S&&e.remove(S),r.set(p,y)}function f(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&u(p)}else u(p);return r.get(p)}function d(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function xE(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),t.update(f,n,1)}function c(u,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,u*o,d),t.update(f,n,d))}function h(u,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,d);let x=0;for(let m=0;m<d;m++)x+=f[m];t.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function bE(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:et("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function vE(i,e,t){let n=new WeakMap,s=new en;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let C=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",C)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],M=0;d===!0&&(M=1),p===!0&&(M=2),x===!0&&(M=3);let y=a.attributes.position.count*M,R=1;y>e.maxTextureSize&&(R=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let S=new Float32Array(y*R*4*u),v=new Xa(S,y,R,u);v.type=Gi,v.needsUpdate=!0;let w=M*4;for(let P=0;P<u;P++){let I=m[P],O=g[P],z=b[P],U=y*R*4*P;for(let G=0;G<I.count;G++){let q=G*w;d===!0&&(s.fromBufferAttribute(I,G),S[U+q+0]=s.x,S[U+q+1]=s.y,S[U+q+2]=s.z,S[U+q+3]=0),p===!0&&(s.fromBufferAttribute(O,G),S[U+q+4]=s.x,S[U+q+5]=s.y,S[U+q+6]=s.z,S[U+q+7]=0),x===!0&&(s.fromBufferAttribute(z,G),S[U+q+8]=s.x,S[U+q+9]=s.y,S[U+q+10]=s.z,S[U+q+11]=z.itemSize===4?s.w:1)}}f={count:u,texture:v,size:new we(y,R)},n.set(a,f),a.addEventListener("dispose",C)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let d=0;for(let x=0;x<c.length;x++)d+=c[x];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function yE(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=e.get(c,u);if(r.get(f)!==h&&(e.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var _E={[Fd]:"LINEAR_TONE_MAPPING",[Od]:"REINHARD_TONE_MAPPING",[kd]:"CINEON_TONE_MAPPING",[Bd]:"ACES_FILMIC_TONE_MAPPING",[Hd]:"AGX_TONE_MAPPING",[Vd]:"NEUTRAL_TONE_MAPPING",[zd]:"CUSTOM_TONE_MAPPING"};function ME(i,e,t,n,s,r){let o=new Xn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new vt;h.setAttribute("position",new rt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new rt([0,2,0,0,2,0],2));let u=new ih({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Ot(h,u),d=new Ri(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,b=null,M=[],y=!1;this.setSize=function(R,S){o.setSize(R,S),a!==null&&a.setSize(R,S),l!==null&&l.setSize(R,S);for(let v=0;v<M.length;v++){let w=M[v];w.setSize&&w.setSize(R,S)}},this.setEffects=function(R){M=R,y=M.length>0&&M[0].isRenderPass===!0;let S=o.width,v=o.height;M.length>0&&a===null&&(a=new Xn(S,v,{type:ns,depthBuffer:!1,stencilBuffer:!1}),l=new Xn(S,v,{type:ns,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(C=>C.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new es(S,v),r===!0&&(c.format=Js,c.type=Xr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let C=0;C<M.length;C++){let P=M[C];P.setSize&&P.setSize(S,v),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(R,S){if(m||R.toneMapping===ws&&M.length===0)return!1;if(b=S,S!==null){let v=S.width,w=S.height;(o.width!==v||o.height!==w)&&this.setSize(v,w)}return y===!1&&R.setRenderTarget(o),g=R.toneMapping,R.toneMapping=ws,!0},this.hasRenderPass=function(){return y},this.end=function(R,S){R.toneMapping=g,m=!0;let v=o,w=a;for(let C=0;C<M.length;C++){let P=M[C];P.enabled!==!1&&(P.render(R,w,v,S),P.needsSwap!==!1&&(v=w,w=w===a?l:a))}if(p!==R.outputColorSpace||x!==R.toneMapping){p=R.outputColorSpace,x=R.toneMapping,u.defines={},bt.getTransfer(p)===Pt&&(u.defines.SRGB_TRANSFER="");let C=_E[x];C&&(u.defines[C]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,R.setRenderTarget(b),R.render(f,d),b=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Kx=new fi,Qx=new es(1,1),eb=new Ja(1),tb=new Xa,nb=new $c,ib=new ja,Ix=[],Lx=[],Dx=new Float32Array(16),Nx=new Float32Array(9),Ux=new Float32Array(4);function Ko(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Ix[s];if(r===void 0&&(r=new Float32Array(s),Ix[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function An(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Rn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function hu(i,e){let t=Lx[e];t===void 0&&(t=new Int32Array(e),Lx[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function wE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function SE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;i.uniform2fv(this.addr,e),Rn(t,e)}}function EE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(An(t,e))return;i.uniform3fv(this.addr,e),Rn(t,e)}}function TE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;i.uniform4fv(this.addr,e),Rn(t,e)}}function AE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(An(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Rn(t,e)}else{if(An(t,n))return;Ux.set(n),i.uniformMatrix2fv(this.addr,!1,Ux),Rn(t,n)}}function RE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(An(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Rn(t,e)}else{if(An(t,n))return;Nx.set(n),i.uniformMatrix3fv(this.addr,!1,Nx),Rn(t,n)}}function CE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(An(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Rn(t,e)}else{if(An(t,n))return;Dx.set(n),i.uniformMatrix4fv(this.addr,!1,Dx),Rn(t,n)}}function PE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function IE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;i.uniform2iv(this.addr,e),Rn(t,e)}}function LE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(An(t,e))return;i.uniform3iv(this.addr,e),Rn(t,e)}}function DE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;i.uniform4iv(this.addr,e),Rn(t,e)}}function NE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function UE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(An(t,e))return;i.uniform2uiv(this.addr,e),Rn(t,e)}}function FE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(An(t,e))return;i.uniform3uiv(this.addr,e),Rn(t,e)}}function OE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(An(t,e))return;i.uniform4uiv(this.addr,e),Rn(t,e)}}function uu(i){return i.version===0&&(i.compareFunction=Kd,i.needsUpdate=!0),i}function kE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=uu(Qx):r=Kx,t.setTexture2D(e||r,s)}function BE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||nb,s)}function zE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=uu(eb):r=ib,t.setTextureCube(e||r,s)}function HE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||tb,s)}function VE(i){switch(i){case 5126:return wE;case 35664:return SE;case 35665:return EE;case 35666:return TE;case 35674:return AE;case 35675:return RE;case 35676:return CE;case 5124:case 35670:return PE;case 35667:case 35671:return IE;case 35668:case 35672:return LE;case 35669:case 35673:return DE;case 5125:return NE;case 36294:return UE;case 36295:return FE;case 36296:return OE;case 35678:case 36198:case 36298:case 36306:case 35682:return kE;case 35679:case 36299:case 36307:return BE;case 35680:case 36300:case 36308:case 36293:return zE;case 36289:case 36303:case 36311:case 36292:return HE}}function GE(i,e){i.uniform1fv(this.addr,e)}function WE(i,e){let t=Ko(e,this.size,2);i.uniform2fv(this.addr,t)}function XE(i,e){let t=Ko(e,this.size,3);i.uniform3fv(this.addr,t)}function qE(i,e){let t=Ko(e,this.size,4);i.uniform4fv(this.addr,t)}function $E(i,e){let t=Ko(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function YE(i,e){let t=Ko(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function ZE(i,e){let t=Ko(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function jE(i,e){i.uniform1iv(this.addr,e)}function JE(i,e){i.uniform2iv(this.addr,e)}function KE(i,e){i.uniform3iv(this.addr,e)}function QE(i,e){i.uniform4iv(this.addr,e)}function eT(i,e){i.uniform1uiv(this.addr,e)}function tT(i,e){i.uniform2uiv(this.addr,e)}function nT(i,e){i.uniform3uiv(this.addr,e)}function iT(i,e){i.uniform4uiv(this.addr,e)}function sT(i,e,t){let n=this.cache,s=e.length,r=hu(t,s);An(n,r)||(i.uniform1iv(this.addr,r),Rn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=uu(Qx):o=Kx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function rT(i,e,t){let n=this.cache,s=e.length,r=hu(t,s);An(n,r)||(i.uniform1iv(this.addr,r),Rn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||nb,r[o])}function oT(i,e,t){let n=this.cache,s=e.length,r=hu(t,s);An(n,r)||(i.uniform1iv(this.addr,r),Rn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=uu(eb):o=ib;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function aT(i,e,t){let n=this.cache,s=e.length,r=hu(t,s);An(n,r)||(i.uniform1iv(this.addr,r),Rn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||tb,r[o])}function lT(i){switch(i){case 5126:return GE;case 35664:return WE;case 35665:return XE;case 35666:return qE;case 35674:return $E;case 35675:return YE;case 35676:return ZE;case 5124:case 35670:return jE;case 35667:case 35671:return JE;case 35668:case 35672:return KE;case 35669:case 35673:return QE;case 5125:return eT;case 36294:return tT;case 36295:return nT;case 36296:return iT;case 35678:case 36198:case 36298:case 36306:case 35682:return sT;case 35679:case 36299:case 36307:return rT;case 35680:case 36300:case 36308:case 36293:return oT;case 36289:case 36303:case 36311:case 36292:return aT}}var up=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=VE(t.type)}},fp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=lT(t.type)}},dp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},cp=/(\w+)(\])?(\[|\.)?/g;function Fx(i,e){i.seq.push(e),i.map[e.id]=e}function cT(i,e,t){let n=i.name,s=n.length;for(cp.lastIndex=0;;){let r=cp.exec(n),o=cp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Fx(t,c===void 0?new up(a,i,e):new fp(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new dp(a),Fx(t,u)),t=u}}}var Jo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);cT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Ox(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var hT=37297,uT=0;function fT(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var kx=new it;function dT(i){bt._getMatrix(kx,bt.workingColorSpace,i);let e=`mat3( ${kx.elements.map(t=>t.toFixed(4))} )`;switch(bt.getTransfer(i)){case Ga:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Bx(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+fT(i.getShaderSource(e),a)}else return r}function pT(i,e){let t=dT(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var mT={[Fd]:"Linear",[Od]:"Reinhard",[kd]:"Cineon",[Bd]:"ACESFilmic",[Hd]:"AgX",[Vd]:"Neutral",[zd]:"Custom"};function gT(i,e){let t=mT[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var au=new N;function xT(){bt.getLuminanceCoefficients(au);let i=au.x.toFixed(4),e=au.y.toFixed(4),t=au.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function bT(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Rl).join(`
`)}function vT(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function yT(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Rl(i){return i!==""}function zx(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Hx(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var _T=/^[ \t]*#include +<([\w\d./]+)>/gm;function pp(i){return i.replace(_T,MT)}function MT(i,e){let t=dt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return pp(t)}var wT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Vx(i){return i.replace(wT,ST)}function ST(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Gx(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var ET={[bl]:"SHADOWMAP_TYPE_PCF",[$o]:"SHADOWMAP_TYPE_VSM"};function TT(i){return ET[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var AT={[Zo]:"ENVMAP_MODE_REFRACTION"};function RT(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":AT[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var CT={[bh]:"ENVMAP_BLENDING_MULTIPLY",[tx]:"ENVMAP_BLENDING_MIX",[nx]:"ENVMAP_BLENDING_ADD"};function PT(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":CT[i.combine]||"ENVMAP_BLENDING_NONE"}function IT(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=TT(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=RT(t),u=PT(t),f=bT(t),d=vT(r),p=s.createProgram(),x,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Rl).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Rl).join(`
`),m.length>0&&(m+=`
`)):(x=[Gx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Rl).join(`
`),m=[Gx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ws?"#define TONE_MAPPING":"",t.toneMapping!==ws?dt.tonemapping_pars_fragment:"",t.toneMapping!==ws?gT("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",dt.colorspace_pars_fragment,pT("linearToOutputTexel",t.outputColorSpace),xT(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Rl).join(`
`)),o=pp(o),o=zx(o,t),o=Hx(o,t),a=pp(a),a=zx(a,t),a=Hx(a,t),o=Vx(o),a=Vx(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",t.glslVersion===Qd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Qd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let b=g+x+o,M=g+m+a,y=Ox(s,s.VERTEX_SHADER,b),R=Ox(s,s.FRAGMENT_SHADER,M);s.attachShader(p,y),s.attachShader(p,R),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function S(P){if(i.debug.checkShaderErrors){let I=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(y)||"",z=s.getShaderInfoLog(R)||"",U=I.trim(),G=O.trim(),q=z.trim(),H=!0,ae=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,y,R);else{let Y=Bx(s,y,"vertex"),ee=Bx(s,R,"fragment");et("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+U+`
`+Y+`
`+ee)}else U!==""?Ye("WebGLProgram: Program Info Log:",U):(G===""||q==="")&&(ae=!1);ae&&(P.diagnostics={runnable:H,programLog:U,vertexShader:{log:G,prefix:x},fragmentShader:{log:q,prefix:m}})}s.deleteShader(y),s.deleteShader(R),v=new Jo(s,p),w=yT(s,p)}let v;this.getUniforms=function(){return v===void 0&&S(this),v};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let C=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return C===!1&&(C=s.getProgramParameter(p,hT)),C},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=uT++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=y,this.fragmentShader=R,this}var LT=0,mp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new gp(e),t.set(e,n)),n}},gp=class{constructor(e){this.id=LT++,this.code=e,this.usedTimes=0}};function DT(i){return i===_r||i===Sl||i===El}function NT(i,e,t,n,s,r){let o=new Bo,a=new mp,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,w,C,P,I,O){let z=P.fog,U=I.geometry,G=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,q=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,H=e.get(v.envMap||G,q),ae=f[v.type],Y=n.precision;v.precision!==null&&(Y=n.getMaxPrecision(v.precision),Y!==v.precision&&Ye("WebGLProgram.getParameters:",v.precision,"not supported, using",Y,"instead."));let ee=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,te=ee!==void 0?ee.length:0,de=0;U.morphAttributes.position!==void 0&&(de=1),U.morphAttributes.normal!==void 0&&(de=2),U.morphAttributes.color!==void 0&&(de=3);let ce,J,ue,ge;if(ae){let Ce=Es[ae];ce=Ce.vertexShader,J=Ce.fragmentShader}else{ce=v.vertexShader,J=v.fragmentShader;let Ce=a.getVertexShaderStage(v),ct=a.getFragmentShaderStage(v);a.update(v,Ce,ct),ue=Ce.id,ge=ct.id}let Se=i.getRenderTarget(),be=i.state.buffers.depth.getReversed(),Ge=I.isInstancedMesh===!0,tt=I.isBatchedMesh===!0,He=!!v.map,lt=!!v.matcap,ot=!!H,je=ot&&H.isPMREMTexture===!0,Kt=!!v.aoMap,Gt=!!v.lightMap,gn=!!v.bumpMap&&v.wireframe===!1,Ut=!!v.normalMap,Ln=!!v.displacementMap,_t=!!v.emissiveMap,En=!!v.metalnessMap,on=!!v.roughnessMap,xn=v.anisotropy>0,B=v.clearcoat>0,Pe=v.diffuseRoughness>0,Ze=v.dispersion>0,at=v.retroreflectivity>0,Ee=v.iridescence>0,Bt=v.sheen>0,Ve=v.transmission>0,$e=xn&&!!v.anisotropyMap,L=B&&!!v.clearcoatMap,E=B&&!!v.clearcoatNormalMap,X=B&&!!v.clearcoatRoughnessMap,fe=Pe&&!!v.diffuseRoughnessMap,oe=Ee&&!!v.iridescenceMap,ve=Ee&&!!v.iridescenceThicknessMap,ye=Bt&&!!v.sheenColorMap,ne=Bt&&!!v.sheenRoughnessMap,se=!!v.specularMap,me=!!v.specularColorMap,k=!!v.specularIntensityMap,re=Ve&&!!v.transmissionMap,ie=Ve&&!!v.thicknessMap,Te=!!v.gradientMap,xe=!!v.alphaMap,Me=v.alphaTest>0,We=!!v.alphaHash,Ke=!!v.extensions,he=ws;v.toneMapped&&(Se===null||Se.isXRRenderTarget===!0)&&(he=i.toneMapping);let ke=je?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Qe={shaderID:ae,shaderType:v.type,shaderName:v.name,vertexShader:ce,fragmentShader:J,defines:v.defines,customVertexShaderID:ue,customFragmentShaderID:ge,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:Y,batching:tt,batchingColor:tt&&I._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&I.instanceColor!==null,instancingMorph:Ge&&I.morphTexture!==null,outputColorSpace:Se===null?i.outputColorSpace:Se.isXRRenderTarget===!0?Se.texture.colorSpace:bt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:He,matcap:lt,envMap:ot,envMapMode:ot&&H.mapping,envMapPMREM:je,envMapMaxLod:je?ke.length-1:null,envMapSize:je?ke[0].width:null,aoMap:Kt,lightMap:Gt,bumpMap:gn,normalMap:Ut,displacementMap:Ln,emissiveMap:_t,normalMapObjectSpace:Ut&&v.normalMapType===rx,normalMapTangentSpace:Ut&&v.normalMapType===ru,packedNormalMap:Ut&&v.normalMapType===ru&&DT(v.normalMap.format),metalnessMap:En,roughnessMap:on,anisotropy:xn,anisotropyMap:$e,clearcoat:B,clearcoatMap:L,clearcoatNormalMap:E,clearcoatRoughnessMap:X,diffuseRoughness:Pe,diffuseRoughnessMap:fe,dispersion:Ze,retroreflection:at,iridescence:Ee,iridescenceMap:oe,iridescenceThicknessMap:ve,sheen:Bt,sheenColorMap:ye,sheenRoughnessMap:ne,specularMap:se,specularColorMap:me,specularIntensityMap:k,transmission:Ve,transmissionMap:re,thicknessMap:ie,gradientMap:Te,opaque:v.transparent===!1&&v.blending===Yo&&v.alphaToCoverage===!1,alphaMap:xe,alphaTest:Me,alphaHash:We,combine:v.combine,mapUv:He&&d(v.map.channel),aoMapUv:Kt&&d(v.aoMap.channel),lightMapUv:Gt&&d(v.lightMap.channel),bumpMapUv:gn&&d(v.bumpMap.channel),normalMapUv:Ut&&d(v.normalMap.channel),displacementMapUv:Ln&&d(v.displacementMap.channel),emissiveMapUv:_t&&d(v.emissiveMap.channel),metalnessMapUv:En&&d(v.metalnessMap.channel),roughnessMapUv:on&&d(v.roughnessMap.channel),anisotropyMapUv:$e&&d(v.anisotropyMap.channel),clearcoatMapUv:L&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:fe&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:ne&&d(v.sheenRoughnessMap.channel),specularMapUv:se&&d(v.specularMap.channel),specularColorMapUv:me&&d(v.specularColorMap.channel),specularIntensityMapUv:k&&d(v.specularIntensityMap.channel),transmissionMapUv:re&&d(v.transmissionMap.channel),thicknessMapUv:ie&&d(v.thicknessMap.channel),alphaMapUv:xe&&d(v.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Ut||xn),vertexNormals:!!U.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!U.attributes.uv&&(He||xe),fog:!!z,useFog:v.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||U.attributes.normal===void 0&&Ut===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:be,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:de,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:O.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:He&&v.map.isVideoTexture===!0&&bt.getTransfer(v.map.colorSpace)===Pt,decodeVideoTextureEmissive:_t&&v.emissiveMap.isVideoTexture===!0&&bt.getTransfer(v.emissiveMap.colorSpace)===Pt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===rn,flipSided:v.side===li,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Ke&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&v.extensions.multiDraw===!0||tt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function x(v){let w=[];if(v.shaderID?w.push(v.shaderID):(w.push(v.customVertexShaderID),w.push(v.customFragmentShaderID)),v.defines!==void 0)for(let C in v.defines)w.push(C),w.push(v.defines[C]);return v.isRawShaderMaterial===!1&&(m(w,v),g(w,v),w.push(i.outputColorSpace)),w.push(v.customProgramCacheKey),w.join()}function m(v,w){v.push(w.precision),v.push(w.outputColorSpace),v.push(w.envMapMode),v.push(w.envMapPMREM),v.push(w.envMapMaxLod),v.push(w.envMapSize),v.push(w.mapUv),v.push(w.alphaMapUv),v.push(w.lightMapUv),v.push(w.aoMapUv),v.push(w.bumpMapUv),v.push(w.normalMapUv),v.push(w.displacementMapUv),v.push(w.emissiveMapUv),v.push(w.metalnessMapUv),v.push(w.roughnessMapUv),v.push(w.anisotropyMapUv),v.push(w.clearcoatMapUv),v.push(w.clearcoatNormalMapUv),v.push(w.clearcoatRoughnessMapUv),v.push(w.diffuseRoughnessMapUv),v.push(w.iridescenceMapUv),v.push(w.iridescenceThicknessMapUv),v.push(w.sheenColorMapUv),v.push(w.sheenRoughnessMapUv),v.push(w.specularMapUv),v.push(w.specularColorMapUv),v.push(w.specularIntensityMapUv),v.push(w.transmissionMapUv),v.push(w.thicknessMapUv),v.push(w.combine),v.push(w.fogExp2),v.push(w.sizeAttenuation),v.push(w.morphTargetsCount),v.push(w.numSunLights),v.push(w.numDirLights),v.push(w.numPointLights),v.push(w.numSpotLights),v.push(w.numSpotLightMaps),v.push(w.numHemiLights),v.push(w.numRectAreaLights),v.push(w.numSunLightShadows),v.push(w.numDirLightShadows),v.push(w.numPointLightShadows),v.push(w.numSpotLightShadows),v.push(w.numSpotLightShadowsWithMaps),v.push(w.numLightProbes),v.push(w.numLightProbeGrids),v.push(w.shadowMapType),v.push(w.toneMapping),v.push(w.numClippingPlanes),v.push(w.numClipIntersection),v.push(w.depthPacking)}function g(v,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function b(v){let w=f[v.type],C;if(w){let P=Es[w];C=Sx.clone(P.uniforms)}else C=v.uniforms;return C}function M(v,w){let C=h.get(w);return C!==void 0?++C.usedTimes:(C=new IT(i,w,v,s),c.push(C),h.set(w,C)),C}function y(v){if(--v.usedTimes===0){let w=c.indexOf(v);c[w]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function S(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:b,acquireProgram:M,releaseProgram:y,releaseShaderCache:R,programs:c,dispose:S}}function UT(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function FT(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Wx(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Xx(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,p,x,m,g){let b=i[e];return b===void 0?(b={id:f.id,object:f,geometry:d,material:p,materialVariant:o(f),groupOrder:x,renderOrder:f.renderOrder,z:m,group:g},i[e]=b):(b.id=f.id,b.object=f,b.geometry=d,b.material=p,b.materialVariant=o(f),b.groupOrder=x,b.renderOrder=f.renderOrder,b.z=m,b.group=g),e++,b}function l(f,d,p,x,m,g,b){b.reversedDepth===!0&&(m=-m);let M=a(f,d,p,x,m,g);p.transmission>0?n.push(M):p.transparent===!0?s.push(M):t.push(M)}function c(f,d,p,x,m,g){let b=a(f,d,p,x,m,g);p.transmission>0?n.unshift(b):p.transparent===!0?s.unshift(b):t.unshift(b)}function h(f,d){t.length>1&&t.sort(f||FT),n.length>1&&n.sort(d||Wx),s.length>1&&s.sort(d||Wx)}function u(){for(let f=e,d=i.length;f<d;f++){let p=i[f];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function OT(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Xx,i.set(n,[o])):s>=r.length?(o=new Xx,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function kT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new N,color:new qe};break;case"SpotLight":t={position:new N,direction:new N,color:new qe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new N,color:new qe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new N,skyColor:new qe,groundColor:new qe};break;case"RectAreaLight":t={color:new qe,position:new N,halfWidth:new N,halfHeight:new N};break}return i[e.id]=t,t}}}function BT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var zT=0;function HT(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function VT(i){let e=new kT,t=BT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new N);let s=new N,r=new wt,o=new wt;function a(c){let h=0,u=0,f=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let d=0,p=0,x=0,m=0,g=0,b=0,M=0,y=0,R=0,S=0,v=0,w=0,C=0,P=0;c.sort(HT);for(let O=0,z=c.length;O<z;O++){let U=c[O],G=U.color,q=U.intensity,H=U.distance,ae=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===_r?ae=U.shadow.map.texture:ae=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=G.r*q,u+=G.g*q,f+=G.b*q;else if(U.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(U.sh.coefficients[Y],q);P++}else if(U.isSunLight){let Y=e.get(U);if(Y.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let ee=U.shadow,te=t.get(U);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),n.sunShadow[p]=te,n.sunShadowMap[p]=ae;let de=ee.getViewportCount();for(let ce=0;ce<de;ce++)n.sunShadowMatrix[x+ce]=ee.getMatrix(ce),n.sunShadowCascade[x+ce]=ee._cascadeData[ce];x+=de,p++}n.sun[d]=Y,d++}else if(U.isDirectionalLight){let Y=e.get(U);if(Y.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let ee=U.shadow,te=t.get(U);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize=ee.mapSize,n.directionalShadow[m]=te,n.directionalShadowMap[m]=ae,n.directionalShadowMatrix[m]=U.shadow.matrix,R++}n.directional[m]=Y,m++}else if(U.isSpotLight){let Y=e.get(U);Y.position.setFromMatrixPosition(U.matrixWorld),Y.color.copy(G).multiplyScalar(q),Y.distance=H,Y.coneCos=Math.cos(U.angle),Y.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),Y.decay=U.decay,n.spot[b]=Y;let ee=U.shadow;if(U.map&&(n.spotLightMap[w]=U.map,w++,ee.updateMatrices(U),U.castShadow&&C++),n.spotLightMatrix[b]=ee.matrix,U.castShadow){let te=t.get(U);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize=ee.mapSize,n.spotShadow[b]=te,n.spotShadowMap[b]=ae,v++}b++}else if(U.isRectAreaLight){let Y=e.get(U);Y.color.copy(G).multiplyScalar(q),Y.halfWidth.set(U.width*.5,0,0),Y.halfHeight.set(0,U.height*.5,0),n.rectArea[M]=Y,M++}else if(U.isPointLight){let Y=e.get(U);if(Y.color.copy(U.color).multiplyScalar(U.intensity),Y.distance=U.distance,Y.decay=U.decay,U.castShadow){let ee=U.shadow,te=t.get(U);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize=ee.mapSize,te.shadowCameraNear=ee.camera.near,te.shadowCameraFar=ee.camera.far,n.pointShadow[g]=te,n.pointShadowMap[g]=ae,n.pointShadowMatrix[g]=U.shadow.matrix,S++}n.point[g]=Y,g++}else if(U.isHemisphereLight){let Y=e.get(U);Y.skyColor.copy(U.color).multiplyScalar(q),Y.groundColor.copy(U.groundColor).multiplyScalar(q),n.hemi[y]=Y,y++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=De.LTC_FLOAT_1,n.rectAreaLTC2=De.LTC_FLOAT_2):(n.rectAreaLTC1=De.LTC_HALF_1,n.rectAreaLTC2=De.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let I=n.hash;(I.sunLength!==d||I.directionalLength!==m||I.pointLength!==g||I.spotLength!==b||I.rectAreaLength!==M||I.hemiLength!==y||I.numSunShadows!==p||I.numDirectionalShadows!==R||I.numPointShadows!==S||I.numSpotShadows!==v||I.numSpotMaps!==w||I.numLightProbes!==P)&&(n.sun.length=d,n.directional.length=m,n.spot.length=b,n.rectArea.length=M,n.point.length=g,n.hemi.length=y,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=S,n.pointShadowMap.length=S,n.pointShadowMatrix.length=S,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+w-C,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=C,n.numLightProbes=P,I.sunLength=d,I.directionalLength=m,I.pointLength=g,I.spotLength=b,I.rectAreaLength=M,I.hemiLength=y,I.numSunShadows=p,I.numDirectionalShadows=R,I.numPointShadows=S,I.numSpotShadows=v,I.numSpotMaps=w,I.numLightProbes=P,n.version=zT++)}function l(c,h){let u=0,f=0,d=0,p=0,x=0,m=0,g=h.matrixWorldInverse;for(let b=0,M=c.length;b<M;b++){let y=c[b];if(y.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(y.matrixWorld),R.direction.transformDirection(g),u++}else if(y.isDirectionalLight){let R=n.directional[f];R.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),f++}else if(y.isSpotLight){let R=n.spot[p];R.position.setFromMatrixPosition(y.matrixWorld),R.position.applyMatrix4(g),R.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),p++}else if(y.isRectAreaLight){let R=n.rectArea[x];R.position.setFromMatrixPosition(y.matrixWorld),R.position.applyMatrix4(g),o.identity(),r.copy(y.matrixWorld),r.premultiply(g),o.extractRotation(r),R.halfWidth.set(y.width*.5,0,0),R.halfHeight.set(0,y.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),x++}else if(y.isPointLight){let R=n.point[d];R.position.setFromMatrixPosition(y.matrixWorld),R.position.applyMatrix4(g),d++}else if(y.isHemisphereLight){let R=n.hemi[m];R.direction.setFromMatrixPosition(y.matrixWorld),R.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function qx(i){let e=new VT(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function GT(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new qx(i),e.set(s,[a])):r>=o.length?(a=new qx(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var WT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,XT=`uniform sampler2D shadow_pass;
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
}`,qT=[new N(1,0,0),new N(-1,0,0),new N(0,1,0),new N(0,-1,0),new N(0,0,1),new N(0,0,-1)],$T=[new N(0,-1,0),new N(0,-1,0),new N(0,0,1),new N(0,0,-1),new N(0,-1,0),new N(0,-1,0)],$x=new wt,Al=new N,hp=new N;function YT(i,e,t){let n=new gr,s=new we,r=new we,o=new en,a=new sh,l=new rh,c={},h=t.maxTextureSize,u={[Ms]:li,[li]:Ms,[rn]:rn},f=new Hi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new we},radius:{value:4}},vertexShader:WT,fragmentShader:XT}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let p=new vt;p.setAttribute("position",new mn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Ot(p,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=bl;let g=this.type;this.render=function(S,v,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||S.length===0)return;this.type===F0&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=bl);let C=i.getRenderTarget(),P=i.getActiveCubeFace(),I=i.getActiveMipmapLevel(),O=i.state;O.setBlending(Zs),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=g!==this.type;z&&v.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(G=>G.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,G=S.length;U<G;U++){let q=S[U],H=q.shadow;if(H===void 0){Ye("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ae=H.getFrameExtents();s.multiply(ae),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ae.x),s.x=r.x*ae.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ae.y),s.y=r.y*ae.y,H.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Y,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===$o){if(q.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Xn(s.x,s.y,{format:_r,type:ns,minFilter:ai,magFilter:ai,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new es(s.x,s.y,Gi),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=Hs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Wt,H.map.depthTexture.magFilter=Wt}else q.isPointLight?(H.map=new Cl(s.x),H.map.depthTexture=new Ja(s.x,Ci)):(H.map=new Xn(s.x,s.y),H.map.depthTexture=new es(s.x,s.y,Ci)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=Hs,this.type===bl?(H.map.depthTexture.compareFunction=Y?Jd:jd,H.map.depthTexture.minFilter=ai,H.map.depthTexture.magFilter=ai):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Wt,H.map.depthTexture.magFilter=Wt);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let ee=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,w);let te=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:w.layers;for(let de=0;de<ee;de++){let ce=H.getCamera(de);if(q.isPointLight){let J=H.camera,ue=H.matrix,ge=q.distance||J.far;ge!==J.far&&(J.far=ge,J.updateProjectionMatrix()),Al.setFromMatrixPosition(q.matrixWorld),J.position.copy(Al),hp.copy(J.position),hp.add(qT[de]),J.up.copy($T[de]),J.lookAt(hp),J.updateMatrixWorld(),ue.makeTranslation(-Al.x,-Al.y,-Al.z),$x.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),H._frustum.setFromProjectionMatrix($x,J.coordinateSystem,J.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,de),i.clear();else{de===0&&(i.setRenderTarget(H.map),i.clear());let J=H.getViewport(de);o.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),O.viewport(o)}n=H.getFrustum(de),y(v,w,ce,q,te,this.type)}H.isPointLightShadow!==!0&&this.type===$o&&b(H,w),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(C,P,I)};function b(S,v){let w=e.update(x);f.defines.VSM_SAMPLES!==S.blurSamples&&(f.defines.VSM_SAMPLES=S.blurSamples,d.defines.VSM_SAMPLES=S.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),S.mapPass===null?S.mapPass=new Xn(s.x,s.y,{format:_r,type:ns}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),f.uniforms.shadow_pass.value=S.map.depthTexture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,i.setRenderTarget(S.mapPass),i.clear(),i.renderBufferDirect(v,null,w,f,x,null),d.uniforms.shadow_pass.value=S.mapPass.texture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,i.setRenderTarget(S.map),i.clear(),i.renderBufferDirect(v,null,w,d,x,null)}function M(S,v,w,C){let P=null,I=w.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(I!==void 0)P=I;else if(P=w.isPointLight===!0?l:a,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let O=P.uuid,z=v.uuid,U=c[O];U===void 0&&(U={},c[O]=U);let G=U[z];G===void 0&&(G=P.clone(),U[z]=G,v.addEventListener("dispose",R)),P=G}if(P.visible=v.visible,P.wireframe=v.wireframe,C===$o?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:u[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let O=i.properties.get(P);O.light=w}return P}function y(S,v,w,C,P,I){if(S.visible===!1)return;if(S.layers.test(P)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&I===$o)&&(!S.frustumCulled||S.intersectsFrustum(n))){S.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,S.matrixWorld);let U=e.update(S),G=S.material;if(Array.isArray(G)){let q=U.groups;for(let H=0,ae=q.length;H<ae;H++){let Y=q[H],ee=G[Y.materialIndex];if(ee&&ee.visible){let te=M(S,ee,C,I);S.onBeforeShadow(i,S,v,w,U,te,Y),i.renderBufferDirect(w,null,U,te,S,Y),S.onAfterShadow(i,S,v,w,U,te,Y)}}}else if(G.visible){let q=M(S,G,C,I);S.onBeforeShadow(i,S,v,w,U,q,null),i.renderBufferDirect(w,null,U,q,S,null),S.onAfterShadow(i,S,v,w,U,q,null)}}let z=S.children;for(let U=0,G=z.length;U<G;U++)y(z[U],v,w,C,P,I)}function R(S){S.target.removeEventListener("dispose",R);for(let w in c){let C=c[w],P=S.target.uuid;P in C&&(C[P].dispose(),delete C[P])}}}function ZT(i,e){function t(){let k=!1,re=new en,ie=null,Te=new en(0,0,0,0);return{setMask:function(xe){ie!==xe&&!k&&(i.colorMask(xe,xe,xe,xe),ie=xe)},setLocked:function(xe){k=xe},setClear:function(xe,Me,We,Ke,he){he===!0&&(xe*=Ke,Me*=Ke,We*=Ke),re.set(xe,Me,We,Ke),Te.equals(re)===!1&&(i.clearColor(xe,Me,We,Ke),Te.copy(re))},reset:function(){k=!1,ie=null,Te.set(-1,0,0,0)}}}function n(){let k=!1,re=!1,ie=null,Te=null,xe=null;return{setReversed:function(Me){if(re!==Me){let We=e.get("EXT_clip_control");Me?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=Me;let Ke=xe;xe=null,this.setClear(Ke)}},getReversed:function(){return re},setTest:function(Me){Me?be(i.DEPTH_TEST):Ge(i.DEPTH_TEST)},setMask:function(Me){ie!==Me&&!k&&(i.depthMask(Me),ie=Me)},setFunc:function(Me){if(re&&(Me=gx[Me]),Te!==Me){switch(Me){case Uc:i.depthFunc(i.NEVER);break;case Fc:i.depthFunc(i.ALWAYS);break;case Oc:i.depthFunc(i.LESS);break;case No:i.depthFunc(i.LEQUAL);break;case kc:i.depthFunc(i.EQUAL);break;case Bc:i.depthFunc(i.GEQUAL);break;case zc:i.depthFunc(i.GREATER);break;case Hc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Me}},setLocked:function(Me){k=Me},setClear:function(Me){xe!==Me&&(xe=Me,re&&(Me=1-Me),i.clearDepth(Me))},reset:function(){k=!1,ie=null,Te=null,xe=null,re=!1}}}function s(){let k=!1,re=null,ie=null,Te=null,xe=null,Me=null,We=null,Ke=null,he=null;return{setTest:function(ke){k||(ke?be(i.STENCIL_TEST):Ge(i.STENCIL_TEST))},setMask:function(ke){re!==ke&&!k&&(i.stencilMask(ke),re=ke)},setFunc:function(ke,Qe,Ce){(ie!==ke||Te!==Qe||xe!==Ce)&&(i.stencilFunc(ke,Qe,Ce),ie=ke,Te=Qe,xe=Ce)},setOp:function(ke,Qe,Ce){(Me!==ke||We!==Qe||Ke!==Ce)&&(i.stencilOp(ke,Qe,Ce),Me=ke,We=Qe,Ke=Ce)},setLocked:function(ke){k=ke},setClear:function(ke){he!==ke&&(i.clearStencil(ke),he=ke)},reset:function(){k=!1,re=null,ie=null,Te=null,xe=null,Me=null,We=null,Ke=null,he=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,p=[],x=null,m=!1,g=null,b=null,M=null,y=null,R=null,S=null,v=null,w=new qe(0,0,0),C=0,P=!1,I=null,O=null,z=null,U=null,G=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ae=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec(Y)[1]),H=ae>=1):Y.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),H=ae>=2);let ee=null,te={},de=i.getParameter(i.SCISSOR_BOX),ce=i.getParameter(i.VIEWPORT),J=new en().fromArray(de),ue=new en().fromArray(ce);function ge(k,re,ie,Te){let xe=new Uint8Array(4),Me=i.createTexture();i.bindTexture(k,Me),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let We=0;We<ie;We++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,xe):i.texImage2D(re+We,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xe);return Me}let Se={};Se[i.TEXTURE_2D]=ge(i.TEXTURE_2D,i.TEXTURE_2D,1),Se[i.TEXTURE_CUBE_MAP]=ge(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Se[i.TEXTURE_2D_ARRAY]=ge(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Se[i.TEXTURE_3D]=ge(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),be(i.DEPTH_TEST),o.setFunc(No),gn(!1),Ut(Pd),be(i.CULL_FACE),Kt(Zs);function be(k){h[k]!==!0&&(i.enable(k),h[k]=!0)}function Ge(k){h[k]!==!1&&(i.disable(k),h[k]=!1)}function tt(k,re){return f[k]!==re?(i.bindFramebuffer(k,re),f[k]=re,k===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=re),k===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=re),!0):!1}function He(k,re){let ie=p,Te=!1;if(k){ie=d.get(re),ie===void 0&&(ie=[],d.set(re,ie));let xe=k.textures;if(ie.length!==xe.length||ie[0]!==i.COLOR_ATTACHMENT0){for(let Me=0,We=xe.length;Me<We;Me++)ie[Me]=i.COLOR_ATTACHMENT0+Me;ie.length=xe.length,Te=!0}}else ie[0]!==i.BACK&&(ie[0]=i.BACK,Te=!0);Te&&i.drawBuffers(ie)}function lt(k){return x!==k?(i.useProgram(k),x=k,!0):!1}let ot={[Gr]:i.FUNC_ADD,[k0]:i.FUNC_SUBTRACT,[B0]:i.FUNC_REVERSE_SUBTRACT};ot[z0]=i.MIN,ot[H0]=i.MAX;let je={[V0]:i.ZERO,[G0]:i.ONE,[W0]:i.SRC_COLOR,[Nd]:i.SRC_ALPHA,[j0]:i.SRC_ALPHA_SATURATE,[Y0]:i.DST_COLOR,[q0]:i.DST_ALPHA,[X0]:i.ONE_MINUS_SRC_COLOR,[Ud]:i.ONE_MINUS_SRC_ALPHA,[Z0]:i.ONE_MINUS_DST_COLOR,[$0]:i.ONE_MINUS_DST_ALPHA,[J0]:i.CONSTANT_COLOR,[K0]:i.ONE_MINUS_CONSTANT_COLOR,[Q0]:i.CONSTANT_ALPHA,[ex]:i.ONE_MINUS_CONSTANT_ALPHA};function Kt(k,re,ie,Te,xe,Me,We,Ke,he,ke){if(k===Zs){m===!0&&(Ge(i.BLEND),m=!1);return}if(m===!1&&(be(i.BLEND),m=!0),k!==O0){if(k!==g||ke!==P){if((b!==Gr||R!==Gr)&&(i.blendEquation(i.FUNC_ADD),b=Gr,R=Gr),ke)switch(k){case Yo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Id:i.blendFunc(i.ONE,i.ONE);break;case Ld:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Dd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:et("WebGLState: Invalid blending: ",k);break}else switch(k){case Yo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Id:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Ld:et("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Dd:et("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:et("WebGLState: Invalid blending: ",k);break}M=null,y=null,S=null,v=null,w.set(0,0,0),C=0,g=k,P=ke}return}xe=xe||re,Me=Me||ie,We=We||Te,(re!==b||xe!==R)&&(i.blendEquationSeparate(ot[re],ot[xe]),b=re,R=xe),(ie!==M||Te!==y||Me!==S||We!==v)&&(i.blendFuncSeparate(je[ie],je[Te],je[Me],je[We]),M=ie,y=Te,S=Me,v=We),(Ke.equals(w)===!1||he!==C)&&(i.blendColor(Ke.r,Ke.g,Ke.b,he),w.copy(Ke),C=he),g=k,P=!1}function Gt(k,re){k.side===rn?Ge(i.CULL_FACE):be(i.CULL_FACE);let ie=k.side===li;re&&(ie=!ie),gn(ie),k.blending===Yo&&k.transparent===!1?Kt(Zs):Kt(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Te=k.stencilWrite;a.setTest(Te),Te&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),_t(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?be(i.SAMPLE_ALPHA_TO_COVERAGE):Ge(i.SAMPLE_ALPHA_TO_COVERAGE)}function gn(k){I!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),I=k)}function Ut(k){k!==N0?(be(i.CULL_FACE),k!==O&&(k===Pd?i.cullFace(i.BACK):k===U0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ge(i.CULL_FACE),O=k}function Ln(k){k!==z&&(H&&i.lineWidth(k),z=k)}function _t(k,re,ie){k?(be(i.POLYGON_OFFSET_FILL),(U!==re||G!==ie)&&(U=re,G=ie,o.getReversed()&&(re=-re,ie=-ie),i.polygonOffset(re,ie))):Ge(i.POLYGON_OFFSET_FILL)}function En(k){k?be(i.SCISSOR_TEST):Ge(i.SCISSOR_TEST)}function on(k){k===void 0&&(k=i.TEXTURE0+q-1),ee!==k&&(i.activeTexture(k),ee=k)}function xn(k,re,ie){ie===void 0&&(ee===null?ie=i.TEXTURE0+q-1:ie=ee);let Te=te[ie];Te===void 0&&(Te={type:void 0,texture:void 0},te[ie]=Te),(Te.type!==k||Te.texture!==re)&&(ee!==ie&&(i.activeTexture(ie),ee=ie),i.bindTexture(k,re||Se[k]),Te.type=k,Te.texture=re)}function B(){let k=te[ee];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Pe(){try{i.compressedTexImage2D(...arguments)}catch(k){et("WebGLState:",k)}}function Ze(){try{i.compressedTexImage3D(...arguments)}catch(k){et("WebGLState:",k)}}function at(){try{i.texSubImage2D(...arguments)}catch(k){et("WebGLState:",k)}}function Ee(){try{i.texSubImage3D(...arguments)}catch(k){et("WebGLState:",k)}}function Bt(){try{i.compressedTexSubImage2D(...arguments)}catch(k){et("WebGLState:",k)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(k){et("WebGLState:",k)}}function $e(){try{i.texStorage2D(...arguments)}catch(k){et("WebGLState:",k)}}function L(){try{i.texStorage3D(...arguments)}catch(k){et("WebGLState:",k)}}function E(){try{i.texImage2D(...arguments)}catch(k){et("WebGLState:",k)}}function X(){try{i.texImage3D(...arguments)}catch(k){et("WebGLState:",k)}}function fe(k){return u[k]!==void 0?u[k]:i.getParameter(k)}function oe(k,re){u[k]!==re&&(i.pixelStorei(k,re),u[k]=re)}function ve(k){J.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),J.copy(k))}function ye(k){ue.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),ue.copy(k))}function ne(k,re){let ie=c.get(re);ie===void 0&&(ie=new WeakMap,c.set(re,ie));let Te=ie.get(k);Te===void 0&&(Te=i.getUniformBlockIndex(re,k.name),i.uniformBlockBinding(re,Te,Te),ie.set(k,Te))}function se(k,re,ie){let xe=c.get(re).get(k);l[xe]!==ie&&(i.bindBufferBase(i.UNIFORM_BUFFER,xe,ie),l[xe]=ie)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},ee=null,te={},f={},l={},d=new WeakMap,p=[],x=null,m=!1,g=null,b=null,M=null,y=null,R=null,S=null,v=null,w=new qe(0,0,0),C=0,P=!1,I=null,O=null,z=null,U=null,G=null,J.set(0,0,i.canvas.width,i.canvas.height),ue.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:be,disable:Ge,bindFramebuffer:tt,drawBuffers:He,useProgram:lt,setBlending:Kt,setMaterial:Gt,setFlipSided:gn,setCullFace:Ut,setLineWidth:Ln,setPolygonOffset:_t,setScissorTest:En,activeTexture:on,bindTexture:xn,unbindTexture:B,compressedTexImage2D:Pe,compressedTexImage3D:Ze,texImage2D:E,texImage3D:X,pixelStorei:oe,getParameter:fe,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:$e,texStorage3D:L,texSubImage2D:at,texSubImage3D:Ee,compressedTexSubImage2D:Bt,compressedTexSubImage3D:Ve,scissor:ve,viewport:ye,reset:me}}function jT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new we,h=new WeakMap,u=new Set,f,d=new WeakMap,p=new Set,x=new FinalizationRegistry(L=>p.delete(L)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,E){return m?new OffscreenCanvas(L,E):Wa("canvas")}function b(L,E,X){let fe=1,oe=$e(L);if((oe.width>X||oe.height>X)&&(fe=X/Math.max(oe.width,oe.height)),fe<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let ve=Math.floor(fe*oe.width),ye=Math.floor(fe*oe.height);f===void 0&&(f=g(ve,ye));let ne=E?g(ve,ye):f;return ne.width=ve,ne.height=ye,ne.getContext("2d").drawImage(L,0,0,ve,ye),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ve+"x"+ye+")."),ne}else return"data"in L&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),L;return L}function M(L){return L.generateMipmaps}function y(L){i.generateMipmap(L)}function R(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(L,E,X,fe,oe,ve=!1){if(L!==null){if(i[L]!==void 0)return i[L];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let ye;fe&&(ye=e.get("EXT_texture_norm16"),ye||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=E;if(E===i.RED&&(X===i.FLOAT&&(ne=i.R32F),X===i.HALF_FLOAT&&(ne=i.R16F),X===i.UNSIGNED_BYTE&&(ne=i.R8),X===i.UNSIGNED_SHORT&&ye&&(ne=ye.R16_EXT),X===i.SHORT&&ye&&(ne=ye.R16_SNORM_EXT)),E===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(ne=i.R8UI),X===i.UNSIGNED_SHORT&&(ne=i.R16UI),X===i.UNSIGNED_INT&&(ne=i.R32UI),X===i.BYTE&&(ne=i.R8I),X===i.SHORT&&(ne=i.R16I),X===i.INT&&(ne=i.R32I)),E===i.RG&&(X===i.FLOAT&&(ne=i.RG32F),X===i.HALF_FLOAT&&(ne=i.RG16F),X===i.UNSIGNED_BYTE&&(ne=i.RG8),X===i.UNSIGNED_SHORT&&ye&&(ne=ye.RG16_EXT),X===i.SHORT&&ye&&(ne=ye.RG16_SNORM_EXT)),E===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(ne=i.RG8UI),X===i.UNSIGNED_SHORT&&(ne=i.RG16UI),X===i.UNSIGNED_INT&&(ne=i.RG32UI),X===i.BYTE&&(ne=i.RG8I),X===i.SHORT&&(ne=i.RG16I),X===i.INT&&(ne=i.RG32I)),E===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(ne=i.RGB8UI),X===i.UNSIGNED_SHORT&&(ne=i.RGB16UI),X===i.UNSIGNED_INT&&(ne=i.RGB32UI),X===i.BYTE&&(ne=i.RGB8I),X===i.SHORT&&(ne=i.RGB16I),X===i.INT&&(ne=i.RGB32I)),E===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(ne=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(ne=i.RGBA16UI),X===i.UNSIGNED_INT&&(ne=i.RGBA32UI),X===i.BYTE&&(ne=i.RGBA8I),X===i.SHORT&&(ne=i.RGBA16I),X===i.INT&&(ne=i.RGBA32I)),E===i.RGB&&(X===i.UNSIGNED_SHORT&&ye&&(ne=ye.RGB16_EXT),X===i.SHORT&&ye&&(ne=ye.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(ne=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(ne=i.R11F_G11F_B10F)),E===i.RGBA){let se=ve?Ga:bt.getTransfer(oe);X===i.FLOAT&&(ne=i.RGBA32F),X===i.HALF_FLOAT&&(ne=i.RGBA16F),X===i.UNSIGNED_BYTE&&(ne=se===Pt?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&ye&&(ne=ye.RGBA16_EXT),X===i.SHORT&&ye&&(ne=ye.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(ne=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(ne=i.RGB5_A1)}return(ne===i.R16F||ne===i.R32F||ne===i.RG16F||ne===i.RG32F||ne===i.RGBA16F||ne===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function v(L,E){let X;return L?E===null||E===Ci||E===Xr?X=i.DEPTH24_STENCIL8:E===Gi?X=i.DEPTH32F_STENCIL8:E===jo&&(X=i.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===Ci||E===Xr?X=i.DEPTH_COMPONENT24:E===Gi?X=i.DEPTH_COMPONENT32F:E===jo&&(X=i.DEPTH_COMPONENT16),X}function w(L,E){return M(L)===!0||L.isFramebufferTexture&&L.minFilter!==Wt&&L.minFilter!==ai?Math.log2(Math.max(E.width,E.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?E.mipmaps.length:1}function C(L){let E=new WeakRef(L);n.get(L).__ref=E,p.add(E),x.register(L,E,E)}function P(L){let E=n.get(L).__ref;E!==void 0&&(p.delete(E),x.unregister(E))}function I(L){z(L.target)}function O(L){U(L.target)}function z(L){L.removeEventListener("dispose",I),P(L),q(L),L.isVideoTexture&&h.delete(L),L.isHTMLTexture&&u.delete(L)}function U(L){L.removeEventListener("dispose",O),P(L),ae(L)}function G(){for(let L of p){let E=L.deref();E!==void 0&&(E.isRenderTarget===!0?U(E):z(E))}p.clear(),u.clear()}function q(L){let E=n.get(L);if(E.__webglInit===void 0)return;let X=L.source,fe=d.get(X);if(fe){let oe=fe[E.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(L),Object.keys(fe).length===0&&d.delete(X)}n.remove(L)}function H(L){let E=n.get(L);i.deleteTexture(E.__webglTexture);let X=L.source,fe=d.get(X);delete fe[E.__cacheKey],o.memory.textures--}function ae(L){let E=n.get(L);E.__depthDisposeCallback&&E.__depthDisposeCallback();let X=L.depthTexture;if(X&&X.renderTarget===L&&z(X),L.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(E.__webglFramebuffer[oe]))for(let ve=0;ve<E.__webglFramebuffer[oe].length;ve++)i.deleteFramebuffer(E.__webglFramebuffer[oe][ve]);else i.deleteFramebuffer(E.__webglFramebuffer[oe]);E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer[oe])}else{if(Array.isArray(E.__webglFramebuffer))for(let oe=0;oe<E.__webglFramebuffer.length;oe++)i.deleteFramebuffer(E.__webglFramebuffer[oe]);else i.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&i.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let oe=0;oe<E.__webglColorRenderbuffer.length;oe++)E.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(E.__webglColorRenderbuffer[oe]);E.__webglDepthRenderbuffer&&i.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let fe=L.textures;for(let oe=0,ve=fe.length;oe<ve;oe++){let ye=n.get(fe[oe]);ye.__webglTexture&&(i.deleteTexture(ye.__webglTexture),o.memory.textures--),n.remove(fe[oe])}n.remove(L)}let Y=0;function ee(){Y=0}function te(){return Y}function de(L){Y=L}function ce(){let L=Y;return L>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,L}function J(L){let E=[];return E.push(L.wrapS),E.push(L.wrapT),E.push(L.wrapR||0),E.push(L.magFilter),E.push(L.minFilter),E.push(L.anisotropy),E.push(L.internalFormat),E.push(L.format),E.push(L.type),E.push(L.generateMipmaps),E.push(L.mipmapsAutoUpdate),E.push(L.premultiplyAlpha),E.push(L.flipY),E.push(L.unpackAlignment),E.push(L.colorSpace),E.join()}function ue(L,E){let X=n.get(L);if(L.isVideoTexture&&Bt(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&X.__version!==L.version){let fe=L.image;if(fe===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(fe.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Gt(X,L,E);return}}else L.isExternalTexture&&(X.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+E)}function ge(L,E){let X=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&X.__version!==L.version){Gt(X,L,E);return}else L.isExternalTexture&&(X.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+E)}function Se(L,E){let X=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&X.__version!==L.version){Gt(X,L,E);return}t.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+E)}function be(L,E){let X=n.get(L);if(L.version>0&&X.__version!==L.version){gn(X,L,E);return}t.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+E)}let Ge={[Vc]:i.REPEAT,[xs]:i.CLAMP_TO_EDGE,[Gc]:i.MIRRORED_REPEAT},tt={[Wt]:i.NEAREST,[ix]:i.NEAREST_MIPMAP_NEAREST,[vl]:i.NEAREST_MIPMAP_LINEAR,[ai]:i.LINEAR,[_h]:i.LINEAR_MIPMAP_NEAREST,[js]:i.LINEAR_MIPMAP_LINEAR},He={[ax]:i.NEVER,[Kd]:i.ALWAYS,[lx]:i.LESS,[jd]:i.LEQUAL,[cx]:i.EQUAL,[Jd]:i.GEQUAL,[hx]:i.GREATER,[ux]:i.NOTEQUAL};function lt(L,E){if(E.type===Gi&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===ai||E.magFilter===_h||E.magFilter===vl||E.magFilter===js||E.minFilter===ai||E.minFilter===_h||E.minFilter===vl||E.minFilter===js)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,Ge[E.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,Ge[E.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,Ge[E.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,tt[E.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,tt[E.minFilter]),E.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,He[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Wt||E.minFilter!==vl&&E.minFilter!==js||E.type===Gi&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||n.get(E).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");i.texParameterf(L,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),n.get(E).__currentAnisotropy=E.anisotropy}}}function ot(L,E){let X=!1;L.__webglInit===void 0&&(L.__webglInit=!0,E.addEventListener("dispose",I),C(E));let fe=E.source,oe=d.get(fe);oe===void 0&&(oe={},d.set(fe,oe));let ve=J(E);if(ve!==L.__cacheKey){oe[ve]===void 0&&(oe[ve]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[ve].usedTimes++;let ye=oe[L.__cacheKey];ye!==void 0&&(oe[L.__cacheKey].usedTimes--,ye.usedTimes===0&&H(E)),L.__cacheKey=ve,L.__webglTexture=oe[ve].texture}return X}function je(L,E,X){return Math.floor(Math.floor(L/X)/E)}function Kt(L,E,X,fe){let ve=L.updateRanges;if(ve.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,E.width,E.height,X,fe,E.data);else{ve.sort((k,re)=>k.start-re.start);let ye=0;for(let k=1;k<ve.length;k++){let re=ve[ye],ie=ve[k],Te=re.start+re.count,xe=je(ie.start,E.width,4),Me=je(re.start,E.width,4);ie.start<=Te+1&&xe===Me&&je(ie.start+ie.count-1,E.width,4)===xe?re.count=Math.max(re.count,ie.start+ie.count-re.start):(++ye,ve[ye]=ie)}ve.length=ye+1;let ne=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,E.width);for(let k=0,re=ve.length;k<re;k++){let ie=ve[k],Te=Math.floor(ie.start/4),xe=Math.ceil(ie.count/4),Me=Te%E.width,We=Math.floor(Te/E.width),Ke=xe,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(i.UNPACK_SKIP_ROWS,We),t.texSubImage2D(i.TEXTURE_2D,0,Me,We,Ke,he,X,fe,E.data)}L.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ne),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Gt(L,E,X){let fe=i.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(fe=i.TEXTURE_2D_ARRAY),E.isData3DTexture&&(fe=i.TEXTURE_3D);let oe=ot(L,E),ve=E.source;t.bindTexture(fe,L.__webglTexture,i.TEXTURE0+X);let ye=n.get(ve);if(ve.version!==ye.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let he=bt.getPrimaries(bt.workingColorSpace),ke=E.colorSpace===Ks?null:bt.getPrimaries(E.colorSpace),Qe=E.colorSpace===Ks||he===ke?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment);let se=b(E.image,!1,s.maxTextureSize);se=Ve(E,se);let me=r.convert(E.format,E.colorSpace),k=r.convert(E.type),re=S(E.internalFormat,me,k,E.normalized,E.colorSpace,E.isVideoTexture);lt(fe,E);let ie,Te=E.mipmaps,xe=E.isVideoTexture!==!0,Me=ye.__version===void 0||oe===!0,We=ve.dataReady,Ke=w(E,se);if(E.isDepthTexture)re=v(E.format===Js,E.type),Me&&(xe?t.texStorage2D(i.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,me,k,null));else if(E.isDataTexture)if(Te.length>0){xe&&Me&&t.texStorage2D(i.TEXTURE_2D,Ke,re,Te[0].width,Te[0].height);for(let he=0,ke=Te.length;he<ke;he++)ie=Te[he],xe?We&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,k,ie.data):t.texImage2D(i.TEXTURE_2D,he,re,ie.width,ie.height,0,me,k,ie.data);E.generateMipmaps=!1}else xe?(Me&&t.texStorage2D(i.TEXTURE_2D,Ke,re,se.width,se.height),We&&Kt(E,se,me,k)):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,me,k,se.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){xe&&Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,re,Te[0].width,Te[0].height,se.depth);for(let he=0,ke=Te.length;he<ke;he++)if(ie=Te[he],E.format!==is)if(me!==null)if(xe){if(We)if(E.layerUpdates.size>0){let Qe=lp(ie.width,ie.height,E.format,E.type);for(let Ce of E.layerUpdates){let ct=ie.data.subarray(Ce*Qe/ie.data.BYTES_PER_ELEMENT,(Ce+1)*Qe/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Ce,ie.width,ie.height,1,me,ct)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,se.depth,me,ie.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,re,ie.width,ie.height,se.depth,0,ie.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?We&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,se.depth,me,k,ie.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,re,ie.width,ie.height,se.depth,0,me,k,ie.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{xe&&Me&&t.texStorage2D(i.TEXTURE_2D,Ke,re,Te[0].width,Te[0].height);for(let he=0,ke=Te.length;he<ke;he++)ie=Te[he],E.format!==is?me!==null?xe?We&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,ie.data):t.compressedTexImage2D(i.TEXTURE_2D,he,re,ie.width,ie.height,0,ie.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?We&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,k,ie.data):t.texImage2D(i.TEXTURE_2D,he,re,ie.width,ie.height,0,me,k,ie.data)}else if(E.isDataArrayTexture)if(xe){if(Me&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,re,se.width,se.height,se.depth),We)if(E.layerUpdates.size>0){let he=lp(se.width,se.height,E.format,E.type);for(let ke of E.layerUpdates){let Qe=se.data.subarray(ke*he/se.data.BYTES_PER_ELEMENT,(ke+1)*he/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,me,k,Qe)}E.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,me,k,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,me,k,se.data);else if(E.isData3DTexture)xe?(Me&&t.texStorage3D(i.TEXTURE_3D,Ke,re,se.width,se.height,se.depth),We&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,me,k,se.data)):t.texImage3D(i.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,me,k,se.data);else if(E.isFramebufferTexture){if(Me)if(xe)t.texStorage2D(i.TEXTURE_2D,Ke,re,se.width,se.height);else{let he=se.width,ke=se.height;for(let Qe=0;Qe<Ke;Qe++)t.texImage2D(i.TEXTURE_2D,Qe,re,he,ke,0,me,k,null),he>>=1,ke>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),se.parentNode!==he){he.appendChild(se),u.add(E),he.onpaint=ke=>{let Qe=ke.changedElements;for(let Ce of u)Qe.includes(Ce.image)&&(Ce.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let Qe=i.RGBA,Ce=i.RGBA,ct=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Qe,Ce,ct,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(xe&&Me){let he=$e(Te[0]);t.texStorage2D(i.TEXTURE_2D,Ke,re,he.width,he.height)}for(let he=0,ke=Te.length;he<ke;he++)ie=Te[he],xe?We&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,me,k,ie):t.texImage2D(i.TEXTURE_2D,he,re,me,k,ie);E.generateMipmaps=!1}else if(xe){if(Me){let he=$e(se);t.texStorage2D(i.TEXTURE_2D,Ke,re,he.width,he.height)}We&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,k,se)}else t.texImage2D(i.TEXTURE_2D,0,re,me,k,se);M(E)&&E.mipmapsAutoUpdate===!0&&y(fe),ye.__version=ve.version,E.onUpdate&&E.onUpdate(E)}L.__version=E.version}function gn(L,E,X){if(E.image.length!==6)return;let fe=ot(L,E),oe=E.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+X);let ve=n.get(oe);if(oe.version!==ve.__version||fe===!0){t.activeTexture(i.TEXTURE0+X);let ye=bt.getPrimaries(bt.workingColorSpace),ne=E.colorSpace===Ks?null:bt.getPrimaries(E.colorSpace),se=E.colorSpace===Ks||ye===ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let me=E.isCompressedTexture||E.image[0].isCompressedTexture,k=E.image[0]&&E.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!me&&!k?re[Ce]=b(E.image[Ce],!0,s.maxCubemapSize):re[Ce]=k?E.image[Ce].image:E.image[Ce],re[Ce]=Ve(E,re[Ce]);let ie=re[0],Te=r.convert(E.format,E.colorSpace),xe=r.convert(E.type),Me=S(E.internalFormat,Te,xe,E.normalized,E.colorSpace),We=E.isVideoTexture!==!0,Ke=ve.__version===void 0||fe===!0,he=oe.dataReady,ke=w(E,ie);lt(i.TEXTURE_CUBE_MAP,E);let Qe;if(E.isDepthTexture){if(Me=v(E.format===Js,E.type),Ke)if(We)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Me,ie.width,ie.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,ie.width,ie.height,0,Te,xe,null)}else if(me){We&&Ke&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,Me,ie.width,ie.height);for(let Ce=0;Ce<6;Ce++){Qe=re[Ce].mipmaps;for(let ct=0;ct<Qe.length;ct++){let Xt=Qe[ct];E.format!==is?Te!==null?We?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,0,0,Xt.width,Xt.height,Te,Xt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,Me,Xt.width,Xt.height,0,Xt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,0,0,Xt.width,Xt.height,Te,xe,Xt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,Me,Xt.width,Xt.height,0,Te,xe,Xt.data)}}}else{if(Qe=E.mipmaps,We&&Ke){Qe.length>0&&ke++;let Ce=$e(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,Me,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(k){We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,Te,xe,re[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,re[Ce].width,re[Ce].height,0,Te,xe,re[Ce].data);for(let ct=0;ct<Qe.length;ct++){let ei=Qe[ct].image[Ce].image;We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,0,0,ei.width,ei.height,Te,xe,ei.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,Me,ei.width,ei.height,0,Te,xe,ei.data)}}else{We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Te,xe,re[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,Te,xe,re[Ce]);for(let ct=0;ct<Qe.length;ct++){let Xt=Qe[ct];We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,0,0,Te,xe,Xt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,Me,Te,xe,Xt.image[Ce])}}}M(E)&&E.mipmapsAutoUpdate===!0&&y(i.TEXTURE_CUBE_MAP),ve.__version=oe.version,E.onUpdate&&E.onUpdate(E)}L.__version=E.version}function Ut(L,E,X,fe,oe,ve){let ye=r.convert(X.format,X.colorSpace),ne=r.convert(X.type),se=S(X.internalFormat,ye,ne,X.normalized,X.colorSpace),me=n.get(E),k=n.get(X);if(k.__renderTarget=E,!me.__hasExternalTextures){let re=Math.max(1,E.width>>ve),ie=Math.max(1,E.height>>ve);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,ve,se,re,ie,E.depth,0,ye,ne,null):t.texImage2D(oe,ve,se,re,ie,0,ye,ne,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),Ee(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,fe,oe,k.__webglTexture,0,at(E)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,fe,oe,k.__webglTexture,ve),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Ln(L,E,X){if(i.bindRenderbuffer(i.RENDERBUFFER,L),E.depthBuffer){let fe=E.depthTexture,oe=fe&&fe.isDepthTexture?fe.type:null,ve=v(E.stencilBuffer,oe),ye=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ee(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,at(E),ve,E.width,E.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,at(E),ve,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,ve,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ye,i.RENDERBUFFER,L)}else{let fe=E.textures;for(let oe=0;oe<fe.length;oe++){let ve=fe[oe],ye=r.convert(ve.format,ve.colorSpace),ne=r.convert(ve.type),se=S(ve.internalFormat,ye,ne,ve.normalized,ve.colorSpace);Ee(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,at(E),se,E.width,E.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,at(E),se,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,se,E.width,E.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function _t(L,E,X){let fe=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(E.depthTexture);oe.__renderTarget=E;let ve=fe?E.depthTexture.image[0]:E.depthTexture.image;(!oe.__webglTexture||ve.width!==E.width||ve.height!==E.height)&&(ve.width=E.width,ve.height=E.height,E.depthTexture.needsUpdate=!0),fe?be(E.depthTexture,0):ue(E.depthTexture,0);let ye=oe.__webglTexture,ne=at(E),se=fe?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,me=E.depthTexture.format===Js?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(E.depthTexture.format===Hs)Ee(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,se,ye,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,me,se,ye,0);else if(E.depthTexture.format===Js)Ee(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,se,ye,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,me,se,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function En(L){let E=n.get(L),X=L.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==L.depthTexture){let fe=L.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),fe){let oe=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,fe.removeEventListener("dispose",oe)};fe.addEventListener("dispose",oe),E.__depthDisposeCallback=oe}E.__boundDepthTexture=fe}if(L.depthTexture&&!E.__autoAllocateDepthBuffer)if(X)for(let fe=0;fe<6;fe++)_t(E.__webglFramebuffer[fe],L,fe);else L.texture.mipmaps.length>0?_t(E.__webglFramebuffer[0],L,0):_t(E.__webglFramebuffer,L,0);else if(X){E.__webglDepthbuffer=[];for(let fe=0;fe<6;fe++)if(t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[fe]),E.__webglDepthbuffer[fe]===void 0)E.__webglDepthbuffer[fe]=i.createRenderbuffer(),Ln(E.__webglDepthbuffer[fe],L,!1);else{let oe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=E.__webglDepthbuffer[fe];i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=i.createRenderbuffer(),Ln(E.__webglDepthbuffer,L,!1);else{let oe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=E.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function on(L,E,X){let fe=n.get(L);E!==void 0&&Ut(fe.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&En(L)}function xn(L){let E=L.texture,X=n.get(L),fe=n.get(E);L.addEventListener("dispose",O),C(L);let oe=L.textures,ve=L.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(fe.__webglTexture===void 0&&(fe.__webglTexture=i.createTexture()),fe.__version=E.version,o.memory.textures++),ve){X.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(E.mipmaps.length>0){X.__webglFramebuffer[ne]=[];for(let se=0;se<E.mipmaps.length;se++)X.__webglFramebuffer[ne][se]=i.createFramebuffer()}else X.__webglFramebuffer[ne]=i.createFramebuffer()}else{if(E.mipmaps.length>0){X.__webglFramebuffer=[];for(let ne=0;ne<E.mipmaps.length;ne++)X.__webglFramebuffer[ne]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(ye)for(let ne=0,se=oe.length;ne<se;ne++){let me=n.get(oe[ne]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),o.memory.textures++)}if(L.samples>0&&Ee(L)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ne=0;ne<oe.length;ne++){let se=oe[ne];X.__webglColorRenderbuffer[ne]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[ne]);let me=r.convert(se.format,se.colorSpace),k=r.convert(se.type),re=S(se.internalFormat,me,k,se.normalized,se.colorSpace,L.isXRRenderTarget===!0),ie=at(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,ie,re,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ne,i.RENDERBUFFER,X.__webglColorRenderbuffer[ne])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),Ln(X.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ve){t.bindTexture(i.TEXTURE_CUBE_MAP,fe.__webglTexture),lt(i.TEXTURE_CUBE_MAP,E);for(let ne=0;ne<6;ne++)if(E.mipmaps.length>0)for(let se=0;se<E.mipmaps.length;se++)Ut(X.__webglFramebuffer[ne][se],L,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else Ut(X.__webglFramebuffer[ne],L,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);M(E)?y(i.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let ne=0,se=oe.length;ne<se;ne++){let me=oe[ne],k=n.get(me),re=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(re=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,k.__webglTexture),lt(re,me),Ut(X.__webglFramebuffer,L,me,i.COLOR_ATTACHMENT0+ne,re,0),M(me)&&y(re)}t.unbindTexture()}else{let ne=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ne=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,fe.__webglTexture),lt(ne,E),E.mipmaps.length>0)for(let se=0;se<E.mipmaps.length;se++)Ut(X.__webglFramebuffer[se],L,E,i.COLOR_ATTACHMENT0,ne,se);else Ut(X.__webglFramebuffer,L,E,i.COLOR_ATTACHMENT0,ne,0);M(E)?y(ne):E.mipmaps.length>0&&i.texParameteri(ne,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&En(L)}function B(L){let E=L.textures;for(let X=0,fe=E.length;X<fe;X++){let oe=E[X];if(M(oe)&&oe.mipmapsAutoUpdate===!0){let ve=R(L),ye=n.get(oe).__webglTexture;t.bindTexture(ve,ye),y(ve),t.unbindTexture()}}}let Pe=[];function Ze(L){if(L.samples>0){if(Ee(L)===!1){let E=L.textures,X=L.width,fe=L.height,oe=i.COLOR_BUFFER_BIT,ve=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=n.get(L),ne=E.length>1;if(ne)for(let me=0;me<E.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let me=0;me<E.length;me++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),ne){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let k=n.get(E[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,k,0)}i.blitFramebuffer(0,0,X,fe,0,0,X,fe,oe,i.NEAREST),l===!0&&(Pe.length=0,Pe.push(i.COLOR_ATTACHMENT0+me),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Pe.push(ve),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ne)for(let me=0;me<E.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let k=n.get(E[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,k,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let E=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[E])}}}function at(L){return Math.min(s.maxSamples,L.samples)}function Ee(L){let E=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Bt(L){let E=o.render.frame;h.get(L)!==E&&(h.set(L,E),L.update())}function Ve(L,E){let X=L.colorSpace,fe=L.format,oe=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||X!==Va&&X!==Ks&&(bt.getTransfer(X)===Pt?(fe!==is||oe!==di)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):et("WebGLTextures: Unsupported texture color space:",X)),E}function $e(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=ce,this.resetTextureUnits=ee,this.getTextureUnits=te,this.setTextureUnits=de,this.setTexture2D=ue,this.setTexture2DArray=ge,this.setTexture3D=Se,this.setTextureCube=be,this.rebindTextures=on,this.setupRenderTarget=xn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=En,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Ee,this.dispose=G}function JT(i,e){function t(n,s=Ks){let r,o=bt.getTransfer(s);if(n===di)return i.UNSIGNED_BYTE;if(n===wh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Sh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===qd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===$d)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Wd)return i.BYTE;if(n===Xd)return i.SHORT;if(n===jo)return i.UNSIGNED_SHORT;if(n===Mh)return i.INT;if(n===Ci)return i.UNSIGNED_INT;if(n===Gi)return i.FLOAT;if(n===ns)return i.HALF_FLOAT;if(n===Yd)return i.ALPHA;if(n===Zd)return i.RGB;if(n===is)return i.RGBA;if(n===Hs)return i.DEPTH_COMPONENT;if(n===Js)return i.DEPTH_STENCIL;if(n===Eh)return i.RED;if(n===Th)return i.RED_INTEGER;if(n===_r)return i.RG;if(n===Ah)return i.RG_INTEGER;if(n===Rh)return i.RGBA_INTEGER;if(n===yl||n===_l||n===Ml||n===wl)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===yl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===_l)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ml)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===wl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===yl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===_l)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ml)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===wl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Ch||n===Ph||n===Ih||n===Lh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Ch)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ph)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ih)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Lh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Dh||n===Nh||n===Uh||n===Fh||n===Oh||n===Sl||n===kh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Dh||n===Nh)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Fh)return r.COMPRESSED_R11_EAC;if(n===Oh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Sl)return r.COMPRESSED_RG11_EAC;if(n===kh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Bh||n===zh||n===Hh||n===Vh||n===Gh||n===Wh||n===Xh||n===qh||n===$h||n===Yh||n===Zh||n===jh||n===Jh||n===Kh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Bh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===zh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Vh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Gh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Wh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Xh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===qh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===$h)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Yh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Zh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===jh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Jh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Kh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Qh||n===eu||n===tu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Qh)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===eu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===tu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===nu||n===iu||n===El||n===su)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===nu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===iu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===El)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===su)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Xr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var KT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,QT=`
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

}`,xp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ka(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Hi({vertexShader:KT,fragmentShader:QT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ot(new cl(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},bp=class extends Qi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,p=null,x=typeof XRWebGLBinding<"u",m=new xp,g={},b=t.getContextAttributes(),M=null,y=null,R=[],S=[],v=new we,w=null,C=null,P=new pn;P.viewport=new en;let I=new pn;I.viewport=new en;let O=[P,I],z=new xh,U=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let ue=R[J];return ue===void 0&&(ue=new zo,R[J]=ue),ue.getTargetRaySpace()},this.getControllerGrip=function(J){let ue=R[J];return ue===void 0&&(ue=new zo,R[J]=ue),ue.getGripSpace()},this.getHand=function(J){let ue=R[J];return ue===void 0&&(ue=new zo,R[J]=ue),ue.getHandSpace()};function q(J){let ue=S.indexOf(J.inputSource);if(ue===-1)return;let ge=R[ue];ge!==void 0&&(ge.update(J.inputSource,J.frame,c||o),ge.dispatchEvent({type:J.type,data:J.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ae);for(let J=0;J<R.length;J++){let ue=S[J];ue!==null&&(S[J]=null,R[J].disconnect(ue))}U=null,G=null,m.reset();for(let J in g)delete g[J];if(e.setRenderTarget(M),d=null,f=null,u=null,s=null,y=null,ce.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(v.width,v.height,!1),C!==null){let J=C.camera;J.fov=C.fov,J.zoom=C.zoom,J.updateProjectionMatrix(),C=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,n.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){a=J,n.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(J){c=J},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ae),b.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Se=null,be=null;b.depth&&(be=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=b.stencil?Js:Hs,Se=b.stencil?Xr:Ci);let Ge={colorFormat:t.RGBA8,depthFormat:be,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(Ge),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),y=new Xn(f.textureWidth,f.textureHeight,{format:is,type:di,depthTexture:new es(f.textureWidth,f.textureHeight,Se,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ge={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),y=new Xn(d.framebufferWidth,d.framebufferHeight,{format:is,type:di,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ce.setContext(s),ce.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ae(J){for(let ue=0;ue<J.removed.length;ue++){let ge=J.removed[ue],Se=S.indexOf(ge);Se>=0&&(S[Se]=null,R[Se].disconnect(ge))}for(let ue=0;ue<J.added.length;ue++){let ge=J.added[ue],Se=S.indexOf(ge);if(Se===-1){for(let Ge=0;Ge<R.length;Ge++)if(Ge>=S.length){S.push(ge),Se=Ge;break}else if(S[Ge]===null){S[Ge]=ge,Se=Ge;break}if(Se===-1)break}let be=R[Se];be&&be.connect(ge)}}function Y(J,ue){ue===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(ue.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let ue=J.near,ge=J.far;m.texture!==null&&(m.depthNear>0&&(ue=m.depthNear),m.depthFar>0&&(ge=m.depthFar)),z.near=I.near=P.near=ue,z.far=I.far=P.far=ge,(U!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),U=z.near,G=z.far),z.layers.mask=J.layers.mask|6,P.layers.mask=z.layers.mask&-5,I.layers.mask=z.layers.mask&-3;let Se=J.parent,be=z.cameras;Y(z,Se);for(let Ge=0;Ge<be.length;Ge++)Y(be[Ge],Se);z.projectionMatrix.copy(P.projectionMatrix),z.projectionMatrixInverse.copy(P.projectionMatrixInverse),C===null&&J.isPerspectiveCamera&&(C={camera:J,fov:J.fov,zoom:J.zoom}),ee(J,z,Se)};function ee(J,ue,ge){ge===null?J.matrix.copy(ue.matrixWorld):(J.matrix.copy(ge.matrixWorld),J.matrix.invert(),J.matrix.multiply(ue.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(ue.projectionMatrix),J.projectionMatrixInverse.copy(ue.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=Oo*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(J){l=J,f!==null&&(f.fixedFoveation=J),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=J)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(J){return g[J]};let te=null;function de(J,ue){if(h=ue.getViewerPose(c||o),p=ue,h!==null){let ge=h.views;d!==null&&(e.setRenderTargetFramebuffer(y,d.framebuffer),e.setRenderTarget(y));let Se=!1;ge.length!==z.cameras.length&&(z.cameras.length=0,Se=!0);for(let He=0;He<ge.length;He++){let lt=ge[He],ot=null;if(d!==null)ot=d.getViewport(lt);else{let Kt=u.getViewSubImage(f,lt);ot=Kt.viewport,He===0&&(e.setRenderTargetTextures(y,Kt.colorTexture,Kt.depthStencilTexture),e.setRenderTarget(y))}let je=O[He];je===void 0&&(je=new pn,je.layers.enable(He),je.viewport=new en,O[He]=je),je.matrix.fromArray(lt.transform.matrix),je.matrix.decompose(je.position,je.quaternion,je.scale),je.projectionMatrix.fromArray(lt.projectionMatrix),je.projectionMatrixInverse.copy(je.projectionMatrix).invert(),je.viewport.set(ot.x,ot.y,ot.width,ot.height),He===0&&(z.matrix.copy(je.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Se===!0&&z.cameras.push(je)}let be=s.enabledFeatures;if(be&&be.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let He=u.getDepthInformation(ge[0]);He&&He.isValid&&He.texture&&m.init(He,s.renderState)}if(be&&be.includes("camera-access")&&x){e.state.unbindTexture(),u=n.getBinding();for(let He=0;He<ge.length;He++){let lt=ge[He].camera;if(lt){let ot=g[lt];ot||(ot=new Ka,g[lt]=ot);let je=u.getCameraImage(lt);ot.sourceTexture=je}}}}for(let ge=0;ge<R.length;ge++){let Se=S[ge],be=R[ge];Se!==null&&be!==void 0&&be.update(Se,ue,c||o)}te&&te(J,ue),ue.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ue}),p=null}let ce=new Yx;ce.setAnimationLoop(de),this.setAnimationLoop=function(J){te=J},this.dispose=function(){}}},eA=new wt,sb=new it;sb.set(-1,0,0,0,1,0,0,0,1);function tA(i,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,rp(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,b,M,y){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),f(m,g),g.isMeshPhysicalMaterial&&d(m,g,y)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,b,M):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===li&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===li&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let b=e.get(g),M=b.envMap,y=b.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(eA.makeRotationFromEuler(y)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(sb),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,b,M){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*b,m.scale.value=M*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function f(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function d(m,g,b){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===li&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=b.texture,m.transmissionSamplerSize.value.set(b.width,b.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let b=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(b.matrixWorld),m.nearDistance.value=b.shadow.camera.near,m.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function nA(i,e,t,n){let s={},r={};function o(b,M){let y=M.program;n.uniformBlockBinding(b,y,s[b.id])}function a(b,M){let y=s[b.id];y===void 0&&(p(b),y=l(b),s[b.id]=y,b.addEventListener("dispose",m));let R=M.program;n.updateUBOMapping(b,R);let S=e.render.frame;r[b.id]!==S&&(c(b),r[b.id]=S)}function l(b){let M=i.createBuffer(),y=b.__size,R=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,y,R),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(b){let M=s[b.id],y=b.uniforms,R=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let S=0,v=y.length;S<v;S++){let w=y[S];if(Array.isArray(w))for(let C=0,P=w.length;C<P;C++)h(w[C],S,C,R);else h(w,S,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(b,M,y,R){if(f(b,M,y,R)===!0){let S=b.__offset,v=b.value;if(Array.isArray(v)){let w=0;for(let C=0;C<v.length;C++){let P=v[C],I=x(P,!0);u(P,b.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,b.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,S,b.__data)}}function u(b,M,y){typeof b=="number"||typeof b=="boolean"?M[y]=b:b.isMatrix3?(M[y]=b.elements[0],M[y+1]=b.elements[1],M[y+2]=b.elements[2],M[y+3]=0,M[y+4]=b.elements[3],M[y+5]=b.elements[4],M[y+6]=b.elements[5],M[y+7]=0,M[y+8]=b.elements[6],M[y+9]=b.elements[7],M[y+10]=b.elements[8],M[y+11]=0):ArrayBuffer.isView(b)?M.set(b.subarray(0,M.length-y),y):b.toArray(M,y)}function f(b,M,y,R){let S=b.value,v=M+"_"+y;if(Array.isArray(S)){R[v]===void 0&&(R[v]=[]);let w=R[v],C=!1;for(let P=0;P<S.length;P++)d(S[P],w,P)===!0&&(C=!0);return C}return d(S,R,v)}function d(b,M,y){if(M[y]===void 0)return typeof b=="number"||typeof b=="boolean"?M[y]=b:ArrayBuffer.isView(b)?M[y]=b.slice():M[y]=b.clone(),!0;{let R=M[y];if(typeof b=="number"||typeof b=="boolean"){if(R!==b)return M[y]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(R.equals(b)===!1)return R.copy(b),!0}}return!1}function p(b){let M=b.uniforms,y=0,R=16;for(let v=0,w=M.length;v<w;v++){let C=Array.isArray(M[v])?M[v]:[M[v]];for(let P=0,I=C.length;P<I;P++){let O=C[P],z=Array.isArray(O.value)?O.value:[O.value],U=Array.isArray(M[v])||Array.isArray(O.value),G=y;for(let H=0,ae=z.length;H<ae;H++){let Y=z[H],ee=x(Y,U),te=y%R,de=te%ee.boundary,ce=te+de;y+=de,ce!==0&&R-ce<ee.storage&&(y+=R-ce),H===0&&(G=y),y+=ee.storage}let q=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new q((y-G)/Float32Array.BYTES_PER_ELEMENT),O.__offset=G}}let S=y%R;return S>0&&(y+=R-S),b.__size=y,b.__cache={},this}function x(b,M){let y={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(y.boundary=4,y.storage=4):b.isVector2?(y.boundary=8,y.storage=8):b.isVector3||b.isColor?(y.boundary=16,y.storage=12):b.isVector4?(y.boundary=16,y.storage=16):b.isMatrix3?(y.boundary=16,y.storage=48):b.isMatrix4?(y.boundary=16,y.storage=64):b.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(y.boundary=16,y.storage=b.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",b),M===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function m(b){let M=b.target;M.removeEventListener("dispose",m),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let b in s)i.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:g}}var iA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ss=null;function sA(){return Ss===null&&(Ss=new Ws(iA,16,16,_r,ns),Ss.name="DFG_LUT",Ss.minFilter=ai,Ss.magFilter=ai,Ss.wrapS=xs,Ss.wrapT=xs,Ss.generateMipmaps=!1,Ss.needsUpdate=!0),Ss}var cu=class{constructor(e={}){let{canvas:t=dx(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=di}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=d,m=new Set([Rh,Ah,Th]),g=new Set([di,Ci,jo,Xr,wh,Sh]),b=new Uint32Array(4),M=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},R=null,S=null,v=[],w=[],C=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ws,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,I=!1,O=null,z=null,U=null,G=null;this._outputColorSpace=ri;let q=0,H=0,ae=null,Y=-1,ee=null,te=new en,de=new en,ce=null,J=new qe(0),ue=0,ge=t.width,Se=t.height,be=1,Ge=null,tt=null,He=new en(0,0,ge,Se),lt=new en(0,0,ge,Se),ot=!1,je=new gr,Kt=new Yc,Gt=!1,gn=!1,Ut=new wt,Ln=new N,_t=new en,En={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},on=!1;function xn(){return ae===null?be:1}let B=n;function Pe(A,V){return t.getContext(A,V)}let Ze,at,Ee,Bt,Ve,$e,L,E,X,fe,oe,ve,ye,ne,se,me,k,re,ie,Te,xe,Me,We;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),B===null){let V="webgl2";if(B=Pe(V,A),B===null)throw Pe(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(A){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),et("WebGLRenderer: "+A.message),A}function Ke(){Ze=new mE(B),Ze.init(),xe=new JT(B,Ze),at=new sE(B,Ze,e,xe),Ee=new ZT(B,Ze),at.reversedDepthBuffer&&f&&Ee.buffers.depth.setReversed(!0),z=B.createFramebuffer(),U=B.createFramebuffer(),G=B.createFramebuffer(),Bt=new bE(B),Ve=new UT,$e=new jT(B,Ze,Ee,Ve,at,xe,Bt),L=new pE(P),E=new yM(B),Me=new nE(B,E),X=new gE(B,E,Bt,Me),fe=new yE(B,X,E,Me,Bt),re=new vE(B,at,$e),se=new rE(Ve),oe=new NT(P,L,Ze,at,Me,se),ve=new tA(P,Ve),ye=new OT,ne=new GT(Ze),k=new tE(P,L,Ee,fe,p,l),me=new YT(P,fe,at),We=new nA(B,Bt,at,Ee),ie=new iE(B,Ze,Bt),Te=new xE(B,Ze,Bt),Bt.programs=oe.programs,P.capabilities=at,P.extensions=Ze,P.properties=Ve,P.renderLists=ye,P.shadowMap=me,P.state=Ee,P.info=Bt}x!==di&&(C=new ME(x,t.width,t.height,a,s,r));let he=new bp(P,B);this.xr=he,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=Ze.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Ze.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return be},this.setPixelRatio=function(A){A!==void 0&&(be=A,this.setSize(ge,Se,!1))},this.getSize=function(A){return A.set(ge,Se)},this.setSize=function(A,V,K=!0){if(he.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=A,Se=V,t.width=Math.floor(A*be),t.height=Math.floor(V*be),K===!0&&(t.style.width=A+"px",t.style.height=V+"px"),C!==null&&C.setSize(t.width,t.height),this.setViewport(0,0,A,V)},this.getDrawingBufferSize=function(A){return A.set(ge*be,Se*be).floor()},this.setDrawingBufferSize=function(A,V,K){ge=A,Se=V,be=K,t.width=Math.floor(A*K),t.height=Math.floor(V*K),this.setViewport(0,0,A,V)},this.setEffects=function(A){if(x===di){et("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let V=0;V<A.length;V++)if(A[V].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}C.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(te)},this.getViewport=function(A){return A.copy(He)},this.setViewport=function(A,V,K,$){A.isVector4?He.set(A.x,A.y,A.z,A.w):He.set(A,V,K,$),Ee.viewport(te.copy(He).multiplyScalar(xn()).round())},this.getScissor=function(A){return A.copy(lt)},this.setScissor=function(A,V,K,$){A.isVector4?lt.set(A.x,A.y,A.z,A.w):lt.set(A,V,K,$),Ee.scissor(de.copy(lt).multiplyScalar(xn()).round())},this.getScissorTest=function(){return ot},this.setScissorTest=function(A){Ee.setScissorTest(ot=A)},this.setOpaqueSort=function(A){Ge=A},this.setTransparentSort=function(A){tt=A},this.getClearColor=function(A){return A.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(A=!0,V=!0,K=!0){let $=0;if(A){let Z=!1;if(ae!==null){let Ae=ae.texture.format;Z=m.has(Ae)}if(Z){let Ae=ae.texture.type,Ie=g.has(Ae),Re=k.getClearColor(),Le=k.getClearAlpha(),ze=Re.r,nt=Re.g,pt=Re.b;Ie?(b[0]=ze,b[1]=nt,b[2]=pt,b[3]=Le,B.clearBufferuiv(B.COLOR,0,b)):(M[0]=ze,M[1]=nt,M[2]=pt,M[3]=Le,B.clearBufferiv(B.COLOR,0,M))}else $|=B.COLOR_BUFFER_BIT}V&&($|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&($|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&B.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),O=A},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),k.dispose(),ye.dispose(),ne.dispose(),$e.dispose(),Ve.dispose(),L.dispose(),fe.dispose(),X.dispose(),Me.dispose(),We.dispose(),oe.dispose(),he.dispose(),he.removeEventListener("sessionstart",Gl),he.removeEventListener("sessionend",as),As.stop()};function ke(A){A.preventDefault(),ep("WebGLRenderer: Context Lost."),I=!0}function Qe(){ep("WebGLRenderer: Context Restored."),I=!1;let A=Bt.autoReset,V=me.enabled,K=me.autoUpdate,$=me.needsUpdate,Z=me.type;Ke(),Bt.autoReset=A,me.enabled=V,me.autoUpdate=K,me.needsUpdate=$,me.type=Z}function Ce(A){et("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ct(A){let V=A.target;V.removeEventListener("dispose",ct),Xt(V)}function Xt(A){ei(A),Ve.remove(A)}function ei(A){let V=Ve.get(A).programs;V!==void 0&&(V.forEach(function(K){oe.releaseProgram(K)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,V,K,$,Z,Ae){V===null&&(V=En);let Ie=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Re=xa(A,V,K,$,Z);Ee.setMaterial($,Ie);let Le=K.index,ze=1;if($.wireframe===!0){if(Le=X.getWireframeAttribute(K),Le===void 0)return;ze=2}let nt=K.drawRange,pt=K.attributes.position,Be=nt.start*ze,mt=(nt.start+nt.count)*ze;Ae!==null&&(Be=Math.max(Be,Ae.start*ze),mt=Math.min(mt,(Ae.start+Ae.count)*ze)),Le!==null?(Be=Math.max(Be,0),mt=Math.min(mt,Le.count)):pt!=null&&(Be=Math.max(Be,0),mt=Math.min(mt,pt.count));let nn=mt-Be;if(nn<0||nn===1/0)return;Me.setup(Z,$,Re,K,Le);let Lt,Dt=ie;if(Le!==null&&(Lt=E.get(Le),Dt=Te,Dt.setIndex(Lt)),Z.isMesh)$.wireframe===!0?(Ee.setLineWidth($.wireframeLinewidth*xn()),Dt.setMode(B.LINES)):Dt.setMode(B.TRIANGLES);else if(Z.isLine){let Tn=$.linewidth;Tn===void 0&&(Tn=1),Ee.setLineWidth(Tn*xn()),Z.isLineSegments?Dt.setMode(B.LINES):Z.isLineLoop?Dt.setMode(B.LINE_LOOP):Dt.setMode(B.LINE_STRIP)}else Z.isPoints?Dt.setMode(B.POINTS):Z.isSprite&&Dt.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Dt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Tn=Z._multiDrawStarts,Fe=Z._multiDrawCounts,bn=Z._multiDrawCount,xt=Le?E.get(Le).bytesPerElement:1,Cs=Ve.get($).currentProgram.getUniforms();for(let vn=0;vn<bn;vn++)Cs.setValue(B,"_gl_DrawID",vn),Dt.render(Tn[vn]/xt,Fe[vn])}else if(Z.isInstancedMesh)Dt.renderInstances(Be,nn,Z.count);else if(K.isInstancedBufferGeometry){let Tn=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Fe=Math.min(K.instanceCount,Tn);Dt.renderInstances(Be,nn,Fe)}else Dt.render(Be,nn)};function pa(A,V,K,$){O!==null&&A.isNodeMaterial&&O.setObject($,A),Gt===!0&&se.setState(A,K,!1),A.transparent===!0&&A.side===rn&&A.forceSinglePass===!1?(A.side=li,A.needsUpdate=!0,ls(A,V,$),A.side=Ms,A.needsUpdate=!0,ls(A,V,$),A.side=rn):ls(A,V,$)}this.compile=function(A,V,K=null){K===null&&(K=A),O!==null&&O.renderStart(A,V,K),S=ne.get(K),S.init(V),w.push(S),K.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(S.pushLight(Z),Z.castShadow&&S.pushShadow(Z))}),A!==K&&A.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(S.pushLight(Z),Z.castShadow&&S.pushShadow(Z))}),S.setupLights(),O!==null&&O.updateLights(S.state.lightsArray),gn=this.localClippingEnabled,Gt=se.init(this.clippingPlanes,gn),Gt===!0&&se.setGlobalState(this.clippingPlanes,V),O!==null&&me.render(S.state.shadowsArray,K,V);let $=new Set;return A.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ae=Z.material;if(Ae)if(Array.isArray(Ae))for(let Ie=0;Ie<Ae.length;Ie++){let Re=Ae[Ie];pa(Re,K,V,Z),$.add(Re)}else pa(Ae,K,V,Z),$.add(Ae)}),S=w.pop(),O!==null&&O.renderEnd(),$},this.compileAsync=function(A,V,K=null){let $=this.compile(A,V,K);return new Promise(Z=>{function Ae(){if($.forEach(function(Ie){let Le=Ve.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&$.delete(Ie)}),$.size===0){Z(A);return}setTimeout(Ae,10)}Ze.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let no=null;function xf(A){no&&no(A)}function Gl(){As.stop()}function as(){As.start()}let As=new Yx;As.setAnimationLoop(xf),typeof self<"u"&&As.setContext(self),this.setAnimationLoop=function(A){no=A,he.setAnimationLoop(A),A===null?As.stop():As.start()},he.addEventListener("sessionstart",Gl),he.addEventListener("sessionend",as),this.render=function(A,V){if(V!==void 0&&V.isCamera!==!0){et("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;O!==null&&O.renderStart(A,V);let K=he.enabled===!0&&he.isPresenting===!0,$=C!==null&&(ae===null||K)&&C.begin(P,ae);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(C===null||C.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(V),V=he.getCamera()),A.isScene===!0&&A.onBeforeRender(P,A,V,ae),S=ne.get(A,w.length),S.init(V),S.state.textureUnits=$e.getTextureUnits(),w.push(S),Ut.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Kt.setFromArrayCamera(V):je.setFromProjectionMatrix(Ut,ki,V.reversedDepth),gn=this.localClippingEnabled,Gt=se.init(this.clippingPlanes,gn),R=ye.get(A,v.length),R.init(),v.push(R),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Ie=P.xr.getDepthSensingMesh();Ie!==null&&Rs(Ie,V,-1/0,P.sortObjects)}Rs(A,V,0,P.sortObjects),R.finish(),O!==null&&O.updateLights(S.state.lightsArray),P.sortObjects===!0&&R.sort(Ge,tt),on=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,on&&k.addToRenderList(R,A),this.info.autoReset===!0&&this.info.reset(),Gt===!0&&se.beginShadows();let Z=S.state.shadowsArray;if(me.render(Z,A,V),Gt===!0&&se.endShadows(),($&&C.hasRenderPass())===!1){let Ie=R.opaque,Re=R.transmissive;if(S.setupLights(),V.isArrayCamera){let Le=V.cameras;if(Re.length>0)for(let ze=0,nt=Le.length;ze<nt;ze++){let pt=Le[ze];qi(Ie,Re,A,pt)}on&&k.render(A);for(let ze=0,nt=Le.length;ze<nt;ze++){let pt=Le[ze];ma(R,A,pt,pt.viewport)}}else Re.length>0&&qi(Ie,Re,A,V),on&&k.render(A),ma(R,A,V)}ae!==null&&H===0&&($e.updateMultisampleRenderTarget(ae),$e.updateRenderTargetMipmap(ae)),$&&C.end(P),A.isScene===!0&&A.onAfterRender(P,A,V),Me.resetDefaultState(),Y=-1,ee=null,w.pop(),w.length>0?(S=w[w.length-1],$e.setTextureUnits(S.state.textureUnits),Gt===!0&&se.setGlobalState(P.clippingPlanes,S.state.camera)):S=null,v.pop(),v.length>0?R=v[v.length-1]:R=null,O!==null&&O.renderEnd()};function Rs(A,V,K,$){if(A.visible===!1)return;if(A.layers.test(V.layers)){if(A.isGroup)K=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(V);else if(A.isLight)S.pushLight(A),A.castShadow&&S.pushShadow(A);else if(A.isSprite){let Ie=V.isArrayCamera?Kt:je;if(!A.frustumCulled||A.intersectsFrustum(Ie)){$&&_t.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ut);let Re=fe.update(A),Le=A.material;Le.visible&&R.push(A,Re,Le,K,_t.z,null,V)}}else if(A.isMesh||A.isLine||A.isPoints){let Ie=V.isArrayCamera?Kt:je;if(!A.frustumCulled||A.intersectsFrustum(Ie)){let Re=fe.update(A),Le=A.material;if($&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),_t.copy(A.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),_t.copy(Re.boundingSphere.center)),_t.applyMatrix4(A.matrixWorld).applyMatrix4(Ut)),Array.isArray(Le)){let ze=Re.groups;for(let nt=0,pt=ze.length;nt<pt;nt++){let Be=ze[nt],mt=Le[Be.materialIndex];mt&&mt.visible&&R.push(A,Re,mt,K,_t.z,Be,V)}}else Le.visible&&R.push(A,Re,Le,K,_t.z,null,V)}}}let Ae=A.children;for(let Ie=0,Re=Ae.length;Ie<Re;Ie++)Rs(Ae[Ie],V,K,$)}function ma(A,V,K,$){let{opaque:Z,transmissive:Ae,transparent:Ie}=A;S.setupLightsView(K),Gt===!0&&se.setGlobalState(P.clippingPlanes,K),$&&Ee.viewport(te.copy($)),Z.length>0&&an(Z,V,K),Ae.length>0&&an(Ae,V,K),Ie.length>0&&an(Ie,V,K),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function qi(A,V,K,$){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[$.id]===void 0){let Be=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[$.id]=new Xn(1,1,{generateMipmaps:!0,type:Be?ns:di,minFilter:js,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:bt.workingColorSpace})}let Ae=S.state.transmissionRenderTarget[$.id],Ie=$.viewport||te;Ae.setSize(Ie.z*P.transmissionResolutionScale,Ie.w*P.transmissionResolutionScale);let Re=P.getRenderTarget(),Le=P.getActiveCubeFace(),ze=P.getActiveMipmapLevel();P.setRenderTarget(Ae),P.getClearColor(J),ue=P.getClearAlpha(),ue<1&&P.setClearColor(16777215,.5),P.clear(),on&&k.render(K);let nt=P.toneMapping;P.toneMapping=ws;let pt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),S.setupLightsView($),Gt===!0&&se.setGlobalState(P.clippingPlanes,$),an(A,K,$),$e.updateMultisampleRenderTarget(Ae),$e.updateRenderTargetMipmap(Ae),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let mt=0,nn=V.length;mt<nn;mt++){let Lt=V[mt],{object:Dt,geometry:Tn,material:Fe,group:bn}=Lt;if(Fe.side===rn&&Dt.layers.test($.layers)){let xt=Fe.side;Fe.side=li,Fe.needsUpdate=!0,fn(Dt,K,$,Tn,Fe,bn),Fe.side=xt,Fe.needsUpdate=!0,Be=!0}}Be===!0&&($e.updateMultisampleRenderTarget(Ae),$e.updateRenderTargetMipmap(Ae))}P.setRenderTarget(Re,Le,ze),P.setClearColor(J,ue),pt!==void 0&&($.viewport=pt),P.toneMapping=nt}function an(A,V,K){let $=V.isScene===!0?V.overrideMaterial:null;for(let Z=0,Ae=A.length;Z<Ae;Z++){let Ie=A[Z],{object:Re,geometry:Le,group:ze}=Ie,nt=Ie.material;nt.allowOverride===!0&&$!==null&&(nt=$),Re.layers.test(K.layers)&&fn(Re,V,K,Le,nt,ze)}}function fn(A,V,K,$,Z,Ae){O!==null&&Z.isNodeMaterial&&O.setObject(A,Z),A.onBeforeRender(P,V,K,$,Z,Ae),A.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Z.onBeforeRender(P,V,K,$,A,Ae),Z.transparent===!0&&Z.side===rn&&Z.forceSinglePass===!1?(Z.side=li,Z.needsUpdate=!0,P.renderBufferDirect(K,V,$,Z,A,Ae),Z.side=Ms,Z.needsUpdate=!0,P.renderBufferDirect(K,V,$,Z,A,Ae),Z.side=rn):P.renderBufferDirect(K,V,$,Z,A,Ae),A.onAfterRender(P,V,K,$,Z,Ae)}function dn(A){let V=0;for(let K of A)K.texture!==null&&V++;return V}function ls(A,V,K){V.isScene!==!0&&(V=En);let $=Ve.get(A),Z=S.state.lights,Ae=S.state.shadowsArray,Ie=Z.state.version,Re=oe.getParameters(A,Z.state,Ae,V,K,S.state.lightProbeGridArray),Le=oe.getProgramCacheKey(Re),ze=$.programs;$.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?V.environment:null,$.fog=V.fog;let nt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;$.envMap=L.get(A.envMap||$.environment,nt),$.envMapRotation=$.environment!==null&&A.envMap===null?V.environmentRotation:A.envMapRotation,ze===void 0&&(A.addEventListener("dispose",ct),ze=new Map,$.programs=ze,$.programVariants=new Map);let pt=ze.get(Le);if(pt!==void 0){if($.currentProgram===pt&&$.lightsStateVersion===Ie)return ga(A,Re),pt}else Re.uniforms=oe.getUniforms(A),O!==null&&A.isNodeMaterial&&O.build(A,K,Re),A.onBeforeCompile(Re,P),pt=oe.acquireProgram(Re,Le),ze.set(Le,pt),$.uniforms=Re.uniforms;let Be=$.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Be.clippingPlanes=se.uniform),ga(A,Re),$.needsLights=ir(A),$.lightsStateVersion=Ie,$.needsLights&&(Be.ambientLightColor.value=Z.state.ambient,Be.lightProbe.value=Z.state.probe,Be.sunLights.value=Z.state.sun,Be.sunLightShadows.value=Z.state.sunShadow,Be.directionalLights.value=Z.state.directional,Be.directionalLightShadows.value=Z.state.directionalShadow,Be.spotLights.value=Z.state.spot,Be.spotLightShadows.value=Z.state.spotShadow,Be.rectAreaLights.value=Z.state.rectArea,Be.ltc_1.value=Z.state.rectAreaLTC1,Be.ltc_2.value=Z.state.rectAreaLTC2,Be.pointLights.value=Z.state.point,Be.pointLightShadows.value=Z.state.pointShadow,Be.hemisphereLights.value=Z.state.hemi,Be.sunShadowMatrix.value=Z.state.sunShadowMatrix,Be.sunShadowCascade.value=Z.state.sunShadowCascade,Be.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Be.spotLightMatrix.value=Z.state.spotLightMatrix,Be.spotLightMap.value=Z.state.spotLightMap,Be.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=dn(S.state.lightProbeGridArray),$.currentProgram=pt,$.uniformsList=null,pt}function bi(A,V,K,$,Z){let Ae=Ve.get(A),Ie=Ae.currentProgram.id+","+$+","+Z,Re=Ae.programVariants.get(Ie);return Re===void 0?(Re=ls(A,V,K),Ae.programVariants.set(Ie,Re)):(Ae.currentProgram=Re,Ae.uniformsList=null,Ae.outputColorSpace=$,Ae.toneMapping=Z),Re}function nr(A){if(A.uniformsList===null){let V=A.currentProgram.getUniforms();A.uniformsList=Jo.seqWithValue(V.seq,A.uniforms)}return A.uniformsList}function ga(A,V){let K=Ve.get(A);K.outputColorSpace=V.outputColorSpace,K.batching=V.batching,K.batchingColor=V.batchingColor,K.instancing=V.instancing,K.instancingColor=V.instancingColor,K.instancingMorph=V.instancingMorph,K.skinning=V.skinning,K.morphTargets=V.morphTargets,K.morphNormals=V.morphNormals,K.morphColors=V.morphColors,K.morphTargetsCount=V.morphTargetsCount,K.numClippingPlanes=V.numClippingPlanes,K.numIntersection=V.numClipIntersection,K.vertexAlphas=V.vertexAlphas,K.vertexTangents=V.vertexTangents,K.toneMapping=V.toneMapping}function xa(A,V,K,$,Z){V.isScene!==!0&&(V=En),$e.resetTextureUnits();let Ae=V.fog,Ie=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?V.environment:null,Re=ae===null?P.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:bt.workingColorSpace,Le=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,ze=L.get($.envMap||Ie,Le),nt=$.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,pt=!!K.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Be=!!K.morphAttributes.position,mt=!!K.morphAttributes.normal,nn=!!K.morphAttributes.color,Lt=ws;$.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(Lt=P.toneMapping);let Dt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,Tn=Dt!==void 0?Dt.length:0,Fe=Ve.get($),bn=S.state.lights;if(Gt===!0&&(gn===!0||A!==ee)){let Nt=A===ee&&$.id===Y;se.setState($,A,Nt)}let xt=!1,Cs=!1;$.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==bn.state.version||Z.isBatchedMesh&&Fe.batching===!1||!Z.isBatchedMesh&&Fe.batching===!0||Z.isBatchedMesh&&Fe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Fe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Fe.instancing===!1||!Z.isInstancedMesh&&Fe.instancing===!0||Z.isSkinnedMesh&&Fe.skinning===!1||!Z.isSkinnedMesh&&Fe.skinning===!0||Z.isInstancedMesh&&Fe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Fe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Fe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Fe.instancingMorph===!1&&Z.morphTexture!==null||Fe.envMap!==ze||$.fog===!0&&Fe.fog!==Ae||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==nt||Fe.vertexTangents!==pt||Fe.morphTargets!==Be||Fe.morphNormals!==mt||Fe.morphColors!==nn||Fe.morphTargetsCount!==Tn||Fe.numLightProbeGrids!==dn(S.state.lightProbeGridArray)?xt=!0:(Fe.outputColorSpace!==Re||Fe.toneMapping!==Lt)&&(Cs=!0):(xt=!0,Fe.__version=$.version);let vn=Fe.currentProgram;(xt===!0||Cs===!0)&&(vn=Cs===!0?bi($,V,Z,Re,Lt):ls($,V,Z),O&&$.isNodeMaterial&&O.onUpdateProgram($,vn,Fe));let ro=!1,cs=!1,Ps=!1,ut=vn.getUniforms(),ln=Fe.uniforms;if(Ee.useProgram(vn.program)&&(ro=!0,cs=!0,Ps=!0),$.id!==Y&&(Y=$.id,cs=!0),ro||ee!==A){Ee.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ut.setValue(B,"projectionMatrix",A.projectionMatrix),ut.setValue(B,"viewMatrix",A.matrixWorldInverse);let yn=ut.map.cameraPosition;yn!==void 0&&yn.setValue(B,Ln.setFromMatrixPosition(A.matrixWorld)),at.logarithmicDepthBuffer&&ut.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ut.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),ee!==A&&(ee=A,cs=!0,Ps=!0)}if(Fe.needsLights&&(bn.state.sunShadowMap.length>0&&ut.setValue(B,"sunShadowMap",bn.state.sunShadowMap,$e),bn.state.directionalShadowMap.length>0&&ut.setValue(B,"directionalShadowMap",bn.state.directionalShadowMap,$e),bn.state.spotShadowMap.length>0&&ut.setValue(B,"spotShadowMap",bn.state.spotShadowMap,$e),bn.state.pointShadowMap.length>0&&ut.setValue(B,"pointShadowMap",bn.state.pointShadowMap,$e)),Z.isSkinnedMesh){ut.setOptional(B,Z,"bindMatrix"),ut.setOptional(B,Z,"bindMatrixInverse");let Nt=Z.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),ut.setValue(B,"boneTexture",Nt.boneTexture,$e))}Z.isBatchedMesh&&(ut.setOptional(B,Z,"batchingTexture"),ut.setValue(B,"batchingTexture",Z._matricesTexture,$e),ut.setOptional(B,Z,"batchingIdTexture"),ut.setValue(B,"batchingIdTexture",Z._indirectTexture,$e),ut.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ut.setValue(B,"batchingColorTexture",Z._colorsTexture,$e));let ti=K.morphAttributes;if((ti.position!==void 0||ti.normal!==void 0||ti.color!==void 0)&&re.update(Z,K,vn),(cs||Fe.receiveShadow!==Z.receiveShadow)&&(Fe.receiveShadow=Z.receiveShadow,ut.setValue(B,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&V.environment!==null&&(ln.envMapIntensity.value=V.environmentIntensity),ln.dfgLUT!==void 0&&(ln.dfgLUT.value=sA()),cs){if(ut.setValue(B,"toneMappingExposure",P.toneMappingExposure),Fe.needsLights&&io(ln,Ps),Ae&&$.fog===!0&&ve.refreshFogUniforms(ln,Ae),ve.refreshMaterialUniforms(ln,$,be,Se,S.state.transmissionRenderTarget[A.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Nt=y,yn=0;for(let $n of S.state.lightProbeGridArray)$n.texture!==null&&(Nt.textures[yn]=$n.texture,Nt.min[yn]=$n.boundingBox.min,Nt.max[yn]=$n.boundingBox.max,Nt.resolution[yn]=$n.resolution,yn++);for(let $n in Nt)Nt[$n].length=yn;ln.probesSH.value=Nt.textures,ln.probesMin.value=Nt.min,ln.probesMax.value=Nt.max,ln.probesResolution.value=Nt.resolution}Jo.upload(B,nr(Fe),ln,$e)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Jo.upload(B,nr(Fe),ln,$e),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ut.setValue(B,"center",Z.center),ut.setValue(B,"modelViewMatrix",Z.modelViewMatrix),ut.setValue(B,"normalMatrix",Z.normalMatrix),ut.setValue(B,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Nt=$.uniformsGroups;for(let yn=0,$n=Nt.length;yn<$n;yn++){let Wl=Nt[yn];We.update(Wl,vn),We.bind(Wl,vn)}}return vn}function io(A,V){A.ambientLightColor.needsUpdate=V,A.lightProbe.needsUpdate=V,A.sunLights.needsUpdate=V,A.sunLightShadows.needsUpdate=V,A.directionalLights.needsUpdate=V,A.directionalLightShadows.needsUpdate=V,A.pointLights.needsUpdate=V,A.pointLightShadows.needsUpdate=V,A.spotLights.needsUpdate=V,A.spotLightShadows.needsUpdate=V,A.rectAreaLights.needsUpdate=V,A.hemisphereLights.needsUpdate=V}function ir(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(A,V,K){let $=Ve.get(A);$.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ve.get(A.texture).__webglTexture=V,Ve.get(A.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:K,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,V){let K=Ve.get(A);K.__webglFramebuffer=V,K.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(A,V=0,K=0){ae=A,q=V,H=K;let $=null,Z=!1,Ae=!1;if(A){let Re=Ve.get(A);if(Re.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(B.FRAMEBUFFER,Re.__webglFramebuffer),te.copy(A.viewport),de.copy(A.scissor),ce=A.scissorTest,Ee.viewport(te),Ee.scissor(de),Ee.setScissorTest(ce),Y=-1;return}else if(Re.__webglFramebuffer===void 0)$e.setupRenderTarget(A);else if(Re.__hasExternalTextures)$e.rebindTextures(A,Ve.get(A.texture).__webglTexture,Ve.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let nt=A.depthTexture;if(Re.__boundDepthTexture!==nt){if(nt!==null&&Ve.has(nt)&&(A.width!==nt.image.width||A.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(A)}}let Le=A.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Ae=!0);let ze=Ve.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(ze[V])?$=ze[V][K]:$=ze[V],Z=!0):A.samples>0&&$e.useMultisampledRTT(A)===!1?$=Ve.get(A).__webglMultisampledFramebuffer:Array.isArray(ze)?$=ze[K]:$=ze,te.copy(A.viewport),de.copy(A.scissor),ce=A.scissorTest}else te.copy(He).multiplyScalar(be).floor(),de.copy(lt).multiplyScalar(be).floor(),ce=ot;if(K!==0&&($=z),Ee.bindFramebuffer(B.FRAMEBUFFER,$)&&Ee.drawBuffers(A,$),Ee.viewport(te),Ee.scissor(de),Ee.setScissorTest(ce),Z){let Re=Ve.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Re.__webglTexture,K)}else if(Ae){let Re=V;for(let Le=0;Le<A.textures.length;Le++){let ze=Ve.get(A.textures[Le]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Le,ze.__webglTexture,K,Re)}}else if(A!==null&&K!==0){let Re=Ve.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Re.__webglTexture,K)}Y=-1};function so(A){let V=Ve.get(A);return(V.__readFormat!==A.format||V.__readType!==A.type)&&(V.__readFormat=A.format,V.__readType=A.type,V.__formatReadable=at.textureFormatReadable(A.format),V.__typeReadable=at.textureTypeReadable(A.type)),V}this.readRenderTargetPixels=function(A,V,K,$,Z,Ae,Ie,Re=0){if(!(A&&A.isWebGLRenderTarget)){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){Ee.bindFramebuffer(B.FRAMEBUFFER,Le);try{let ze=A.textures[Re],nt=ze.format,pt=ze.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Re);let Be=so(ze);if(Be.__formatReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=A.width-$&&K>=0&&K<=A.height-Z&&B.readPixels(V,K,$,Z,xe.convert(nt),xe.convert(pt),Ae)}finally{let ze=ae!==null?Ve.get(ae).__webglFramebuffer:null;Ee.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(A,V,K,$,Z,Ae,Ie,Re=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(V>=0&&V<=A.width-$&&K>=0&&K<=A.height-Z){Ee.bindFramebuffer(B.FRAMEBUFFER,Le);let ze=A.textures[Re],nt=ze.format,pt=ze.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Re);let Be=so(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.bufferData(B.PIXEL_PACK_BUFFER,Ae.byteLength,B.STREAM_READ),B.readPixels(V,K,$,Z,xe.convert(nt),xe.convert(pt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let nn=ae!==null?Ve.get(ae).__webglFramebuffer:null;Ee.bindFramebuffer(B.FRAMEBUFFER,nn);let Lt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await mx(B,Lt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ae),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(mt),B.deleteSync(Lt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,V=null,K=0){let $=Math.pow(2,-K),Z=Math.floor(A.image.width*$),Ae=Math.floor(A.image.height*$),Ie=V!==null?V.x:0,Re=V!==null?V.y:0;$e.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,K,0,0,Ie,Re,Z,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(A,V,K=null,$=null,Z=0,Ae=0){let Ie,Re,Le,ze,nt,pt,Be,mt,nn,Lt=A.isCompressedTexture?A.mipmaps[Ae]:A.image;if(K!==null)Ie=K.max.x-K.min.x,Re=K.max.y-K.min.y,Le=K.isBox3?K.max.z-K.min.z:1,ze=K.min.x,nt=K.min.y,pt=K.isBox3?K.min.z:0;else{let ut=Math.pow(2,-Z);Ie=Math.floor(Lt.width*ut),Re=Math.floor(Lt.height*ut),A.isDataArrayTexture?Le=Lt.depth:A.isData3DTexture?Le=Math.floor(Lt.depth*ut):Le=1,ze=0,nt=0,pt=0}$!==null?(Be=$.x,mt=$.y,nn=$.z):(Be=0,mt=0,nn=0);let Dt=xe.convert(V.format),Tn=xe.convert(V.type),Fe;V.isData3DTexture?($e.setTexture3D(V,0),Fe=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?($e.setTexture2DArray(V,0),Fe=B.TEXTURE_2D_ARRAY):($e.setTexture2D(V,0),Fe=B.TEXTURE_2D),Ee.activeTexture(B.TEXTURE0),Ee.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),Ee.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Ee.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let bn=Ee.getParameter(B.UNPACK_ROW_LENGTH),xt=Ee.getParameter(B.UNPACK_IMAGE_HEIGHT),Cs=Ee.getParameter(B.UNPACK_SKIP_PIXELS),vn=Ee.getParameter(B.UNPACK_SKIP_ROWS),ro=Ee.getParameter(B.UNPACK_SKIP_IMAGES);Ee.pixelStorei(B.UNPACK_ROW_LENGTH,Lt.width),Ee.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Lt.height),Ee.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),Ee.pixelStorei(B.UNPACK_SKIP_ROWS,nt),Ee.pixelStorei(B.UNPACK_SKIP_IMAGES,pt);let cs=A.isDataArrayTexture||A.isData3DTexture,Ps=V.isDataArrayTexture||V.isData3DTexture;if(A.isDepthTexture){let ut=Ve.get(A),ln=Ve.get(V),ti=Ve.get(ut.__renderTarget),Nt=Ve.get(ln.__renderTarget);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,ti.__webglFramebuffer),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let yn=0;yn<Le;yn++)cs&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(A).__webglTexture,Z,pt+yn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(V).__webglTexture,Ae,nn+yn)),B.blitFramebuffer(ze,nt,ze+Ie,nt+Re,Be,mt,Be+Ie,mt+Re,B.DEPTH_BUFFER_BIT,B.NEAREST);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||A.isRenderTargetTexture||Ve.has(A)){let ut=Ve.get(A),ln=Ve.get(V);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,U),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let ti=0;ti<Le;ti++)cs?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ut.__webglTexture,Z,pt+ti):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ut.__webglTexture,Z),Ps?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ln.__webglTexture,Ae,nn+ti):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ln.__webglTexture,Ae),Z!==0?B.blitFramebuffer(ze,nt,ze+Ie,nt+Re,Be,mt,Be+Ie,mt+Re,B.COLOR_BUFFER_BIT,B.NEAREST):Ps?B.copyTexSubImage3D(Fe,Ae,Be,mt,nn+ti,ze,nt,Ie,Re):B.copyTexSubImage2D(Fe,Ae,Be,mt,ze,nt,Ie,Re);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Ps?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(Fe,Ae,Be,mt,nn,Ie,Re,Le,Dt,Tn,Lt.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Fe,Ae,Be,mt,nn,Ie,Re,Le,Dt,Lt.data):B.texSubImage3D(Fe,Ae,Be,mt,nn,Ie,Re,Le,Dt,Tn,Lt):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ae,Be,mt,Ie,Re,Dt,Tn,Lt.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ae,Be,mt,Lt.width,Lt.height,Dt,Lt.data):B.texSubImage2D(B.TEXTURE_2D,Ae,Be,mt,Ie,Re,Dt,Tn,Lt);Ee.pixelStorei(B.UNPACK_ROW_LENGTH,bn),Ee.pixelStorei(B.UNPACK_IMAGE_HEIGHT,xt),Ee.pixelStorei(B.UNPACK_SKIP_PIXELS,Cs),Ee.pixelStorei(B.UNPACK_SKIP_ROWS,vn),Ee.pixelStorei(B.UNPACK_SKIP_IMAGES,ro),Ae===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Fe),Ee.unbindTexture()},this.initRenderTarget=function(A){Ve.get(A).__webglFramebuffer===void 0&&$e.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?$e.setTextureCube(A,0):A.isData3DTexture?$e.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?$e.setTexture2DArray(A,0):$e.setTexture2D(A,0),Ee.unbindTexture()},this.resetState=function(){q=0,H=0,ae=null,Ee.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ki}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=bt._getDrawingBufferColorSpace(e),t.unpackColorSpace=bt._getUnpackColorSpace()}};var yp={light:i=>$f(.12+.88*i),viridis:Xg,cividis:Gg,magma:qg,turbo:Wg,"blue-red":i=>Vg(1-i)},Mr=new Set(["block","material","level","held","surface","removable_type","removable_mode"]),rA={removable_type:["#a8adb3","#d62728","#f2a33a","#59a14f","#6f9bd1"],removable_mode:["#a8adb3","#59a14f","#f2a33a","#e0662b","#a3123a"]},ab=["#c3ac87","#86a3bd","#b98474","#93ab7d","#a091b5","#cda552","#76aca4","#bd93a8","#a3a39a","#d2bfa6"],Qo=16,oA=.15,pu="#b3b1ab",aA=/\.(x|y|z)$|^rotation$|^spin$|pressure|sigma/;function mu(i){return aA.test(i)?"blue-red":"light"}var mi=256,lA=[128,128,128],fu=document.createElement("canvas").getContext("2d",{willReadFrequently:!0});function vp(i){fu.fillStyle="#000",fu.fillStyle=i,fu.fillRect(0,0,1,1);let[e,t,n]=fu.getImageData(0,0,1,1).data;return[e,t,n]}function Yr(i,e=""){if(e==="material")return ab[(Math.round(i)%10+10)%10];let t=rA[e];return t?t[Math.round(i)]??t[0]:Hg[(Math.round(i)%10+10)%10]}function rb(i){let e=Math.imul(i^739982445,2246822507);return e=Math.imul(e^e>>>13,3266489909),(e^e>>>16)>>>0&Qo-1}function ob(i,e){let t=oA*(2*e/(Qo-1)-1);return vp(i).map(n=>Math.round(t>0?n+t*(255-n):n*(1+t)))}var du=class{texture;low=0;high=1;log=!1;kinds=!1;field="";data=new Uint8Array(8*mi);constructor(){this.texture=new Ws(this.data,2*mi,1),this.texture.colorSpace=ri,this.texture.magFilter=Wt,this.texture.minFilter=Wt,this.paint("light")}paint(e){let t=yp[e]??$f;this.fill(n=>this.toned?ob(Yr(Math.floor(n/Qo),"material"),n%Qo):vp(this.kinds?Yr(n%250,this.field):t(n/(mi-1))))}plain(){this.fill(e=>ob(ab[0],e%Qo))}fill(e){for(let t=0;t<2*mi;t++)this.data.set([...t<mi?e(t):lA,255],4*t);this.data.set([...vp(pu),255],4*(2*mi-1)),this.texture.needsUpdate=!0}get toned(){return this.kinds&&this.field==="material"}get terrain(){return 1-.25/mi}tone(e){return(rb(e)+.5)/(2*mi)}share(e){return this.log?e>0?Math.log(e/this.low)/Math.log(this.high/this.low):-1/0:(e-this.low)/(this.high-this.low)}isBeyond(e){let t=1/(mi-1);return this.share(e)<-t||this.share(e)>1+t}place(e,t){if(!Number.isFinite(e))return .75;if(this.toned)return(Qo*((Math.round(e)%10+10)%10)+rb(t)+.5)/(2*mi);if(this.kinds)return((Math.round(e)%250+250)%250+.5)/(2*mi);let n=this.share(e);return n>0?n>1&&(n=1):n=0,(n*(mi-1)+.5)/(2*mi)}css(e){let t=4*Math.round(Math.min(1,Math.max(0,e))*(mi-1));return`rgb(${this.data[t]}, ${this.data[t+1]}, ${this.data[t+2]})`}};var lb=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"\xB5"],[1e-9,"n"]],cA=new Set(["m","m/s","m/s2","Pa","N","N/m","J","J/m","s","W"]);function _p(i,e){if(e==="-"||e==="")return{factor:1,unit:""};if(!cA.has(e)||!(i>0)||!Number.isFinite(i))return{factor:1,unit:e};let t=lb.find(([n])=>i>=n*.9995)??lb.at(-1);return e.startsWith("m")&&t[0]>1?{factor:1,unit:e}:{factor:1/t[0],unit:t[1]+e}}function kt(i,e=4){if(Number.isNaN(i))return"no number";if(!Number.isFinite(i))return i>0?"\u221E":"-\u221E";if(i===0)return"0";let t=Math.abs(i);if(t>=1e5||t<1e-4){let[n,s]=i.toExponential(Math.max(0,e-2)).split("e");return`${Number(n)}e${Number(s)}`}return String(Number(i.toPrecision(e)))}function un(i,e,t=4){let n=_p(Math.abs(i),e);return n.unit?`${kt(i*n.factor,t)} ${n.unit}`:kt(i*n.factor,t)}function cb(i,e,t=5){if(!(e>i))return[i];let n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=n*.999)??10*s,o=[];for(let a=Math.ceil(i/r-1e-9);a*r<=e+1e-9*r;a++)o.push(a*r);return o}var hA=1e-7,uA=new N(17e-10,29e-10,23e-10);function hb(i,e,t){let n=[],s=i.dimension===3?fA(i,e,t):null;for(let r=0;r<i.count;r++){let o=s?s(r):dA(i,r,e,t);for(let a=0;a+1<o.length;a+=2){let[l,c]=[Math.max(0,o[a]),Math.min(1,o[a+1])];c-l>hA&&n.push({from:l,to:c,block:r})}}return n.sort((r,o)=>r.from-o.from||r.to-o.to)}function fA({positions:i,corners:e,facesOf:t,faceEnds:n},s,r){let o=new N().subVectors(r,s),a=o.length(),l=new N().copy(s).addScaledVector(uA,a);o.divideScalar(a);let c=new N(1,0,0);Math.abs(o.x)>.6&&c.set(0,1,0);let h=new N().crossVectors(o,c).normalize(),u=new N().crossVectors(o,h),[f,d,p]=[[],[],[]];return x=>{let m=[];for(let g=t[x];g<t[x+1];g++){let[b,M]=[n[g],n[g+1]-n[g]],[y,R,S,v]=[!1,!1,!1,!1];for(let C=0;C<M;C++){let P=3*e[b+C],[I,O,z]=[i[P]-l.x,i[P+1]-l.y,i[P+2]-l.z];f[C]=I*h.x+O*h.y+z*h.z,d[C]=I*u.x+O*u.y+z*u.z,p[C]=I*o.x+O*o.y+z*o.z,f[C]>=0&&(R=!0),f[C]<=0&&(y=!0),d[C]>=0&&(v=!0),d[C]<=0&&(S=!0)}if(!y||!R||!S||!v)continue;let w=(C,P)=>f[C]*d[P]-d[C]*f[P];for(let C=1;C+1<M;C++){let[P,I,O]=[w(C,C+1),w(C+1,0),w(0,C)],z=P+I+O;z===0||!(P>=0&&I>=0&&O>=0||P<=0&&I<=0&&O<=0)||m.push((P*p[0]+I*p[C]+O*p[C+1])/(z*a))}}return m.sort((g,b)=>g-b)}}function dA({positions:i,corners:e,facesOf:t,faceEnds:n},s,r,o){let a=[],[l,c]=[o.x-r.x,o.y-r.y];for(let h=t[s];h<t[s+1];h++){let[u,f]=[n[h],n[h+1]];for(let d=u;d<f;d++){let[p,x]=[3*e[d],3*e[d+1<f?d+1:u]],m=S=>l*(i[S+1]-r.y)-c*(i[S]-r.x),[g,b]=[m(p),m(x)];if(g>=0==b>=0)continue;let M=g/(g-b),[y,R]=[i[p]+M*(i[x]-i[p]),i[p+1]+M*(i[x+1]-i[p+1])];a.push(((y-r.x)*l+(R-r.y)*c)/(l*l+c*c))}}return a.sort((h,u)=>h-u)}var gu=class{object=new jt;line;ends;constructor(){let e={color:Mp,depthTest:!1,transparent:!0};this.line=new Ho(new vt,new zi(e)),this.ends=new $s(new vt,new ys({...e,size:9,sizeAttenuation:!1}));for(let t of[this.line,this.ends])t.frustumCulled=!1,t.renderOrder=6,this.object.add(t);this.object.visible=!1}draw(e,t){this.object.visible=e.length>0;let n=e.flatMap(s=>[s.x,s.y,t?.6:s.z]);for(let s of[this.line,this.ends])s.geometry.dispose(),s.geometry.setAttribute("position",new rt(n,3))}},Mp="#e0007a";var ub=new WeakMap;function pA(i){let e=ub.get(i);if(!e){e=new Map;let{twins:t,blockOf:n,count:s}=i;for(let r=0;r<t.length;r+=2){let o=n[t[r]],a=n[t[r+1]];e.set(Math.min(o,a)*s+Math.max(o,a),r)}ub.set(i,e)}return e}function xu(i,e){let t=pA(i),{twins:n,faceEnds:s,corners:r,positions:o,count:a}=i,l=[],c=[];return e.forEach(([h,u],f)=>{let d=t.get(Math.min(h,u)*a+Math.max(h,u));if(d===void 0)return;let p=n[d],x=s[p],m=s[p+1];for(let g=x+1;g+1<m;g++){for(let b of[r[x],r[g],r[g+1]])l.push(o[3*b],o[3*b+1],o[3*b+2]);c.push(f)}}),{points:l,pair:c}}var wp=4e3,Qs=[{name:"touching",colour:"#4b8fd6"},{name:"sliding",colour:"#f0a020"},{name:"softened",colour:"#3aa88f"},{name:"broken",colour:"#e0483e"},{name:"broken in tension",colour:"#d62728"},{name:"broken in shear",colour:"#2c4fb8"},{name:"broken and open",colour:"#b05cd0"},{name:"open",colour:"#c062a8"}],_u=2;function mA(i){if(i){let r=new Go;return r.moveTo(0,-.025).lineTo(.7,-.025).lineTo(.7,-.1).lineTo(1,0),r.lineTo(.7,.1).lineTo(.7,.025).lineTo(0,.025).closePath(),new hl(r)}let e=new Ys(.025,.025,.7,5).translate(0,.35,0),t=new Qa(.09,.3,8).translate(0,.85,0),n=new vt,s=[e.toNonIndexed(),t.toNonIndexed()];for(let r of["position","normal"]){let o=s.map(l=>l.getAttribute(r).array),a=new Float32Array(o[0].length+o[1].length);a.set(o[0]),a.set(o[1],o[0].length),n.setAttribute(r,new mn(a,3))}return n.rotateZ(-Math.PI/2)}var na=new N(1,0,0),wr=class{constructor(e,t={}){this.flat=e;this.material=new qn({side:rn,...t})}flat;object=new jt;mesh=null;material;set colour(e){this.material.color.set(e)}draw(e,t,n,s){this.clear();let r=t.length/3,o=[];for(let f=0;f<r;f++)Math.hypot(t[3*f],t[3*f+1],t[3*f+2])>n*.01&&Number.isFinite(e[3*f])&&o.push(f);let a=Math.max(1,Math.ceil(o.length/wp)),l=o.filter((f,d)=>d%a===0),c=new Xs(mA(this.flat),this.material,l.length),h=new tn,u=new N;l.forEach((f,d)=>{u.fromArray(t,3*f);let p=u.length();h.position.fromArray(e,3*f),this.flat&&(h.position.z+=.5),h.quaternion.setFromUnitVectors(na,u.divideScalar(p));let x=p/n*s,m=Math.max(x,s/3);h.scale.set(x,m,m),h.updateMatrix(),c.setMatrixAt(d,h.matrix)}),c.frustumCulled=!1,c.renderOrder=3,this.mesh=c,this.object.add(c)}clear(){this.mesh&&(this.object.remove(this.mesh),this.mesh.geometry.dispose(),this.mesh.dispose(),this.mesh=null)}},ea=class{object=new jt;geometry=new vt;points;cracks;constructor(e){this.points=new $s(this.geometry,new ys({size:e?6:5,sizeAttenuation:!1,vertexColors:!0,depthTest:!e})),this.cracks=new Ot(new vt,new _s({vertexColors:!0,side:rn,flatShading:!0}));for(let t of[this.points,this.cracks])t.frustumCulled=!1,this.object.add(t);this.points.renderOrder=2,this.clear()}clear(){this.points.visible=!1,this.cracks.visible=!1}end(e){for(let t of[this.points,this.cracks])t.material.clippingPlanes=e}static count(e){let t=Qs.map(()=>0);for(let n of e.u8("states"))t[n]=(t[n]??0)+1;return t}drawPoints(e,t,n){let s=e.u8("states"),r=Qs.map(l=>new qe(l.colour)),o=[],a=[];s.forEach((l,c)=>{n[l]&&(o.push(t[3*c],t[3*c+1],t[3*c+2]),a.push(...r[l].toArray()))}),this.geometry.dispose(),this.geometry.setAttribute("position",new rt(o,3)),this.geometry.setAttribute("color",new rt(a,3)),this.points.visible=o.length>0}drawCracks(e,t,n,s){let r=e.u8("states"),o=e.u32("blockA"),a=e.u32("blockB"),l=[],c=[];r.forEach((x,m)=>{let[g,b]=[o[m]??Il,a[m]??Il],M=t!==null&&(x===4||x===5);x<_u||M||g===Il||b===Il||!n.isShown(g)||!n.isShown(b)||(l.push([g,b]),c.push(x))});let{points:h,pair:u}=xu(n,l),f=u.map(x=>c[x]);t&&vA(t,n,s,h,f);let d=Qs.map(x=>new qe(x.colour)),p=new Float32Array(h.length);f.forEach((x,m)=>{for(let g=0;g<3;g++)d[x].toArray(p,9*m+3*g)}),this.cracks.geometry.dispose(),this.cracks.geometry.setAttribute("position",new rt(h,3)),this.cracks.geometry.setAttribute("color",new mn(p,3)),this.cracks.visible=h.length>0}hide(e){this[e].visible=!1}},ta=class{mesh=null;object=new jt;material=new qn({depthTest:!1,transparent:!0});clear(){this.mesh&&(this.object.remove(this.mesh),this.mesh.geometry.dispose(),this.mesh.dispose(),this.mesh=null)}},bu=class extends ta{draw(e,t,n,s){this.clear();let r=e.f32("points"),o=e.f32("forces"),a=e.u8("states"),l=[e.u32("blockA"),e.u32("blockB")],c=Math.max(Math.abs(e.info.largest??0),Math.abs(e.info.smallest??0))||1,h=new Xs(new Ys(.5,.5,1,6).rotateZ(-Math.PI/2),this.material,o.length),u=new tn,[f,d,p]=[new N,new N,new N],x=new qe;o.forEach((m,g)=>{[f,d].forEach((y,R)=>{let S=l[R][g];y.fromArray(r,6*g+3*R),S<t.count&&y.add(n(S,p))}),p.subVectors(d,f);let b=p.length();u.position.addVectors(f,d).multiplyScalar(.5),b>0&&u.quaternion.setFromUnitVectors(na,p.divideScalar(b));let M=a[g]===xA;u.scale.set(b,M?s/3:s,M?s/3:s),u.updateMatrix(),h.setMatrixAt(g,u.matrix),h.setColorAt(g,M?x.set("#444444"):bA(m/c,x))}),h.frustumCulled=!1,h.renderOrder=4,this.mesh=h,this.object.add(h)}},gA=.02,vu=class extends ta{draw(e,t,n,s){this.clear();let r=e.f32("forces"),o=[e.u32("blockA"),e.u32("blockB")],a=e.info.longest??0,l=[],c=0;for(let p=0;3*p<r.length;p++){let x=Math.hypot(r[3*p],r[3*p+1],r[3*p+2])/a;if(!(x>gA)||!Number.isFinite(t[3*p]))continue;let m=new N().fromArray(t,3*p),g=o.flatMap(b=>n(b[p]??Il)??[]);l.push(...g.map(b=>({from:m,to:b,share:x}))),c+=g.length>0?1:0}let h=new Xs(new Ys(.5,.5,1,8).rotateZ(-Math.PI/2),this.material,l.length),u=new tn,f=new N,d=new qe;return l.sort((p,x)=>p.share-x.share).forEach(({from:p,to:x,share:m},g)=>{f.subVectors(x,p);let b=f.length();u.position.addVectors(p,x).multiplyScalar(.5),b>0&&u.quaternion.setFromUnitVectors(na,f.divideScalar(b)),u.scale.set(b,s*m,s*m),u.updateMatrix(),h.setMatrixAt(g,u.matrix),h.setColorAt(g,d.set("#f7c873").lerp(new qe(Sp),m))}),h.frustumCulled=!1,h.renderOrder=4,this.mesh=h,this.object.add(h),c}},Sp="#8c1313",Ep="#ff7a00",yu=class{object=new jt;material=new qn({color:Ep,depthTest:!1,transparent:!0,opacity:.85});build(e,t,n){for(let s of e){let r=(s.centre?[s.centre]:s.line??[]).map(o=>new N(o[0]-t[0],o[1]-t[1],o[2]-t[2]));for(let o of r)this.add(new ll(n)).position.copy(o);for(let o=0;o+1<r.length;o++){let a=r[o+1].clone().sub(r[o]),l=this.add(new Ys(n/5,n/5,a.length(),6).rotateZ(-Math.PI/2));l.position.copy(r[o]).addScaledVector(a,.5),l.quaternion.setFromUnitVectors(na,a.normalize())}}}add(e){let t=new Ot(e,this.material);return t.renderOrder=4,this.object.add(t),t}},Ll="#1d5fd0",Dl="#d01c1c",xA=3;function bA(i,e){let t=Math.min(1,Math.abs(i));return e.set("#f4f0ea").lerp(new qe(i<0?Ll:Dl),t)}var Il=4294967295;function vA(i,e,t,n,s){let r=i.f32("points"),o=[i.u32("blockA"),i.u32("blockB")],[a,l]=[new N,new N];i.u8("states").forEach((c,h)=>{let u=o.map(f=>f[h]).filter(f=>f<e.count);if(u.some(f=>e.isShown(f))){l.set(0,0,0);for(let f of u)l.addScaledVector(t(f,a),1/u.length);for(let f=0;f<9;f++)n.push(r[9*h+f]+l.getComponent(f%3));s.push(c)}})}function fb(i,e,t){let n=i.f32("points").slice(),s=i.u32("blockA"),r=new N;for(let o=0;o<s.length;o++){let a=s[o];a>=e.count||(t(a,r),n[3*o]=n[3*o]+r.x,n[3*o+1]=n[3*o+1]+r.y,n[3*o+2]=n[3*o+2]+r.z)}return n}var Zr=class{object;constructor(e="#ff2e88",t=5){this.object=new qs(new vt,new zi({color:e,depthTest:!1,transparent:!0})),this.object.renderOrder=t,this.object.frustumCulled=!1,this.object.visible=!1}draw(e){this.object.visible=e!==null,e&&(this.object.geometry.dispose(),this.object.geometry.setAttribute("position",new mn(e,3)))}};function db(i){let e=new wn;if(i.count===0)return e;let t=[0,1,2].map(p=>{let x=Float32Array.from({length:i.count},(b,M)=>i.positions[3*i.offsets[M]+p]).filter(Number.isFinite).sort(),m=b=>x[Math.round(b*(x.length-1))]??0,g=Math.max(.15*(m(.9975)-m(.0025)),i.size);return[m(.0025)-g,m(.9975)+g]}),{positions:n,offsets:s}=i,[[r,o],[a,l],[c,h]]=t,u=p=>{let[x,m,g]=[n[3*p],n[3*p+1],n[3*p+2]];return x>=r&&x<=o&&m>=a&&m<=l&&g>=c&&g<=h},f=[1/0,1/0,1/0],d=[-1/0,-1/0,-1/0];for(let p=0;p<i.count;p++){let[x,m]=[s[p],s[p+1]],g=x;for(;g<m&&!u(g);)g++;if(g!==m)for(let b=3*x;b<3*m;b++){let M=n[b],y=(b-3*x)%3;M<f[y]&&(f[y]=M),M>d[y]&&(d[y]=M)}}return d[0]>=f[0]&&e.set(new N(...f),new N(...d)),e}function pb(i,e,t,n){let{rest:s,positions:r,offsets:o,middles:a}=i;for(let l=0;l<i.count;l++){let c=Math.cos(t[l])-1,h=Math.sin(t[l]),u=e[2*l],f=e[2*l+1],d=a[3*l],p=a[3*l+1];for(let x=3*o[l];x<3*o[l+1];x+=3){let m=s[x]-d,g=s[x+1]-p;r[x]=s[x]+n*(u+c*m-h*g),r[x+1]=s[x+1]+n*(f+h*m+c*g)}}}function mb(i,e,t,n,s){let{rest:r,positions:o,offsets:a,middles:l}=i;for(let c=0;c<i.count;c++){let h=3*c,u=e[h],f=e[h+1],d=e[h+2],p=t[h]*n,x=t[h+1]*n,m=t[h+2]*n,g=p===0&&x===0&&m===0,b=Math.sqrt(Math.max(0,1-p*p-x*x-m*m)),M=l[h],y=l[h+1],R=l[h+2];for(let S=3*a[c];S<3*a[c+1];S+=3){let v=u,w=f,C=d;if(!g){let P=r[S]-M,I=r[S+1]-y,O=r[S+2]-R,z=2*(x*O-m*I),U=2*(m*P-p*O),G=2*(p*I-x*P);v+=b*z+x*G-m*U,w+=b*U+m*z-p*G,C+=b*G+p*U-x*z}o[S]=r[S]+s*v,o[S+1]=r[S+1]+s*w,o[S+2]=r[S+2]+s*C}}}function gb(i,e){let[t,n]=[i,e].map(Jn.degToRad);return[Math.sin(t)*Math.sin(n),Math.sin(t)*Math.cos(n),Math.cos(t)]}function xb(i){let e=Jn.degToRad(i);return[-Math.sin(e),Math.cos(e),0]}function bb(i,e,t,n){let{positions:s,offsets:r,count:o}=i,[a,l,c]=e.normal.map(u=>e.keep*u),h=e.keep*e.at;for(let u=0;u<o;u++){let f=1/0,d=-1/0;for(let p=3*r[u];p<3*r[u+1];p+=3){let x=a*s[p]+l*s[p+1]+c*s[p+2]-h;x<f&&(f=x),x>d&&(d=x)}n[u]=d<=t?0:f>=-t?1:2}}var yA=2**26;function vb(i,e,t){let n={triangles:[],owners:[],lines:[]},s=new N(...e.normal).multiplyScalar(e.keep),r=e.keep*e.at,o=SA(s);for(let a of t){let l=new Map;for(let c=i.facesOf[a];c<i.facesOf[a+1];c++){let h=_A(i,c,s,r);if(!(h.length<2)){h.length>2&&MA(h);for(let u=0;u+1<h.length;u+=2){let[f,d]=[h[u],h[u+1]];i.dimension===2&&n.lines.push(...f.point.toArray(),...d.point.toArray());let[p,x]=f.up?[f,d]:[d,f];l.set(p.edge,{to:x.edge,point:p.point})}}}i.dimension===3&&EA(wA(l),o,a,n)}return n}function _A(i,e,t,n){let{corners:s,faceEnds:r,positions:o}=i,a=r[e],l=r[e+1],c=d=>t.x*o[3*d]+t.y*o[3*d+1]+t.z*o[3*d+2]-n,h=[],u=s[l-1],f=c(u);for(let d=a;d<l;d++){let p=s[d],x=c(p);if(f>=0!=x>=0){let[m,g,b,M]=u<p?[u,p,f,x]:[p,u,x,f],y=b/(b-M),R=new N;for(let S of[0,1,2]){let v=o[3*m+S];R.setComponent(S,v+y*(o[3*g+S]-v))}h.push({edge:m*yA+g,up:x>=0,point:R})}u=p,f=x}return h}function MA(i){let e=i[0].point,n=i.reduce((s,r)=>r.point.distanceToSquared(e)>s.point.distanceToSquared(e)?r:s).point.clone().sub(e);i.sort((s,r)=>s.point.dot(n)-r.point.dot(n))}function wA(i){let e=[];for(let t of i.keys()){let n=[],s=t;for(let r=i.get(s);r;r=i.get(s))n.push(r.point),i.delete(s),s=r.to;s===t&&n.length>2&&e.push(n)}return e}function SA(i){let t=(Math.abs(i.z)<.9?new N(0,0,1):new N(1,0,0)).cross(i).normalize();return[t,t.clone().cross(i)]}function EA(i,[e,t],n,s){let r=i.map(h=>({points:h,flat:h.map(u=>new we(u.dot(e),u.dot(t)))}));for(let{points:h}of r)h.forEach((u,f)=>s.lines.push(...u.toArray(),...h[(f+1)%h.length].toArray()));let o=(h,u,f)=>{s.triangles.push(h.x,h.y,h.z,u.x,u.y,u.z,f.x,f.y,f.z),s.owners.push(n)},a=r[0];if(a&&r.length===1&&TA(a.flat)){let{points:h}=a;for(let u=1;u+1<h.length;u++)o(h[0],h[u],h[u+1]);return}let l=r.filter(h=>bs.area(h.flat)>0),c=r.filter(h=>bs.area(h.flat)<0);for(let h of l){let u=l.length===1?c:c.filter(d=>AA(d.flat[0],h.flat)),f=[...h.points,...u.flatMap(d=>d.points)];for(let[d,p,x]of bs.triangulateShape(h.flat.slice(),u.map(m=>m.flat.slice())))o(f[d],f[p],f[x])}}function TA(i){let e=i.length;for(let t=0;t<e;t++){let[n,s,r]=[i[t],i[(t+1)%e],i[(t+2)%e]],[o,a,l,c]=[s.x-n.x,s.y-n.y,r.x-s.x,r.y-s.y];if(o*c-a*l<-1e-6*Math.hypot(o,a)*Math.hypot(l,c))return!1}return!0}function AA(i,e){let t=!1;return e.forEach((n,s)=>{let r=e[(s+1)%e.length];n.y>i.y!=r.y>i.y&&i.x<n.x+(i.y-n.y)/(r.y-n.y)*(r.x-n.x)&&(t=!t)}),t}var Mu=class{object=new jt;cast;mesh;lines;owners=[];withEdges=!1;constructor(e){let t={map:e,side:rn,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1};this.mesh=new Ot(new vt,new qn(t)),this.lines=new qs(new vt,new zi({color:0,transparent:!0,opacity:.55})),this.cast=new Ot(this.mesh.geometry,new qn({colorWrite:!1,side:rn})),this.cast.frustumCulled=!1;for(let n of[this.mesh,this.lines])n.frustumCulled=!1,this.object.add(n);this.clear()}get count(){return new Set(this.owners).size}clear(){this.object.visible=!1,this.cast.visible=!1,this.owners=[]}draw(e,t,n){let{triangles:s,owners:r,lines:o}=e;this.owners=r,this.object.visible=o.length>0,this.withEdges=n,this.mesh.visible=s.length>0,this.cast.visible=this.mesh.visible;let a=new Float32Array(6*r.length);r.forEach((l,c)=>{for(let h=0;h<3;h++)a[6*c+2*h]=t[l]}),this.mesh.geometry.dispose(),this.mesh.geometry.setAttribute("position",new rt(s,3)),this.mesh.geometry.setAttribute("uv",new mn(a,2)),this.mesh.geometry.boundingSphere=null,this.lines.geometry.dispose(),this.lines.geometry.setAttribute("position",new rt(o,3))}fade(e){this.lines.visible=this.withEdges&&e>0,this.lines.material.opacity=.55*e}pick(e){if(!this.object.visible||!this.mesh.visible)return null;let t=e.intersectObject(this.mesh,!1)[0],n=t?.faceIndex===void 0||t.faceIndex===null?void 0:this.owners[t.faceIndex];return t&&n!==void 0?{block:n,distance:t.distance}:null}set glass(e){let{material:t}=this.mesh;t.transparent=e,t.opacity=e?.14:1,t.depthWrite=!e,t.needsUpdate=!0}dispose(){for(let e of[this.mesh,this.lines])e.geometry.dispose(),e.material.dispose()}};var wu=class{constructor(e,t){this.of=e;this.survey=t}of;survey;kept=new Map;turned=new Map;scratch=new Int32Array(64);at(e){let{faceEnds:t,facesOf:n}=this.of,s=t[n[e+1]]-t[n[e]];if(s<=64)return this.fill(e,s,this.scratch);let r=this.kept.get(e);if(r)return r;let o=this.fill(e,s,new Int32Array(s));return this.kept.set(e,o),o}fill(e,t,n){let{facesOf:s,faceEnds:r,corners:o}=this.of,[a,l]=[s[e],s[e+1]],c=r[a],h=this.survey(e)?.766:.98,u=new Float32Array(3*(l-a));for(let m=a;m<l;m++)this.normal(m,u,3*(m-a));n.fill(-1,0,t);let f=(m,g,b,M)=>{let[y,R]=[3*(g-a),3*(M-a)],v=u[y]*u[R]+u[y+1]*u[R+1]+u[y+2]*u[R+2]<h?1:0;n[m-c]=2*M+v,n[b-c]=2*g+v},{turned:d}=this,p=t>64,x=p?o.subarray(c,c+t).reduce((m,g)=>Math.min(m,g),4294967295):0;d.clear();for(let m=a;m<l;m++){let[g,b]=[r[m],r[m+1]];for(let M=g;M<b;M++){let[y,R]=[o[M],o[M+1<b?M+1:g]];if(p){let S=d.get((R-x)*4194304+(y-x));S!==void 0?f(M,m,S,this.faceOf(S,a,l)):d.set((y-x)*4194304+(R-x),M);continue}for(let S=a;S<m&&n[M-c]===-1;S++){let[v,w]=[r[S],r[S+1]];for(let C=v;C<w;C++)if(o[C]===R&&o[C+1<w?C+1:v]===y){f(M,m,C,S);break}}}}return n}faceOf(e,t,n){let{faceEnds:s}=this.of,[r,o]=[t,n];for(;r+1<o;){let a=r+o>>1;s[a]<=e?r=a:o=a}return r}normal(e,t,n){let{faceEnds:s,corners:r,rest:o}=this.of,[a,l]=[s[e],s[e+1]],c=3*r[a],[h,u,f]=[0,0,0];for(let p=a+1;p+1<l;p++){let[x,m]=[3*r[p],3*r[p+1]],[g,b,M]=[o[x]-o[c],o[x+1]-o[c+1],o[x+2]-o[c+2]],[y,R,S]=[o[m]-o[c],o[m+1]-o[c+1],o[m+2]-o[c+2]];h+=b*S-M*R,u+=M*y-g*S,f+=g*R-b*y}let d=Math.hypot(h,u,f)||1;t[n]=h/d,t[n+1]=u/d,t[n+2]=f/d}};var RA=new Ri(-1,1,1,-1,0,1),Tp=class extends vt{constructor(){super(),this.setAttribute("position",new rt([-1,3,0,-1,-1,0,3,-1,0],3)),this.setAttribute("uv",new rt([0,2,0,0,2,0],2))}},CA=new Tp,Su=class{constructor(e){this._mesh=new Ot(CA,e)}dispose(){this._mesh.geometry.dispose()}render(e){e.render(this._mesh,RA)}get material(){return this._mesh.material}set material(e){this._mesh.material=e}};var PA=2,IA=3,LA=2048,DA=1024,NA="varying vec2 place; void main() { place = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",UA=`
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
`,FA=`
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
`,Ap=new Ws(new Uint8Array([255,255,255,255]),1,1);Ap.needsUpdate=!0;function _b(i,e){i.onBeforeCompile=t=>{t.uniforms.shadeLight=e.light,t.uniforms.shadePoints=e.points,t.fragmentShader=t.fragmentShader.replace("void main() {",`uniform sampler2D shadeLight;
uniform vec2 shadePoints;
void main() {`).replace("#include <aomap_fragment>",`vec2 shade = texture2D(shadeLight, gl_FragCoord.xy / shadePoints).rg;
        reflectedLight.directDiffuse *= shade.g;
        reflectedLight.indirectDiffuse += 0.7 * abs(dot(normal, normalize(vViewPosition))) * BRDF_Lambert(diffuseColor.rgb);
        reflectedLight.indirectDiffuse *= shade.r;
        reflectedLight.directDiffuse *= 0.5 + 0.5 * shade.r;`)}}var Eu=class{constructor(e,t){this.renderer=e;this.software=t;let n=r=>{let o=new Xn(r,r,{minFilter:Wt,magFilter:Wt});return o.depthTexture=new es(r,r,Ci),o};this.depth=n(4),this.sun=n(t?DA:LA),this.found=new Xn(4,4,{minFilter:Wt,magFilter:Wt,depthBuffer:!1}),this.smooth=new Xn(4,4,{depthBuffer:!1});let s=(r,o,a={})=>{let l=Object.fromEntries(o.map(c=>[c,{value:null}]));return new Su(new Hi({vertexShader:NA,fragmentShader:r,uniforms:l,defines:a,depthTest:!1,depthWrite:!1,blending:Zs}))};this.find=s(UA,["depth","sun","back","toSun","points","clip","reach","scale","lift","sunPoint","bias"],{SAMPLES:t?9:14}),this.mean=s(FA,["light","points","near"])}renderer;software;lit={light:{value:Ap},points:{value:new we(1,1)}};depth;found;smooth;sun;sunCamera=new Ri;own=new pn;find;mean;stale=!0;moved(){this.stale=!0}clear(){this.lit.light.value=Ap}draw(e,t,n,s,r){let{renderer:o,own:a,lit:l}=this,c=o.getDrawingBufferSize(l.points.value),h=this.software?IA:PA,[u,f]=[Math.ceil(c.x/h),Math.ceil(c.y/h)];for(let b of[this.depth,this.found,this.smooth])(b.width!==u||b.height!==f)&&b.setSize(u,f);this.stale&&this.fromSun(e,n,s),this.stale=!1,a.copy(t);let d=t.position.distanceTo(n.center);a.far=d+1.01*n.radius,a.near=Math.max(t.near,d-1.01*n.radius,1e-4*a.far),a.updateProjectionMatrix(),a.updateMatrixWorld();let p={color:o.getClearColor(new qe),alpha:o.getClearAlpha()};o.setRenderTarget(this.depth),o.render(e,a);let x=new wt().multiplyMatrices(this.sunCamera.projectionMatrix,this.sunCamera.matrixWorldInverse).multiply(a.matrixWorld),m=2*n.radius/this.sun.width,g=new we(u,f);yb(this.find,{depth:this.depth.depthTexture,sun:this.sun.depthTexture,back:a.projectionMatrixInverse,toSun:x,points:g,clip:new we(a.near,a.far),reach:Math.min(Math.max(.9*r,.02*n.radius),.25*n.radius),scale:.5*f/Math.tan(Jn.degToRad(a.fov/2)),lift:1.6*m,sunPoint:1/this.sun.width,bias:.6*m/(2*n.radius)}),o.setRenderTarget(this.found),this.find.render(o),yb(this.mean,{light:this.found.texture,points:g,near:.02}),o.setRenderTarget(this.smooth),this.mean.render(o),o.setRenderTarget(null),o.setClearColor(p.color,p.alpha),l.light.value=this.smooth.texture}fromSun(e,t,n){let{sunCamera:s,renderer:r}=this,o=t.radius;Object.assign(s,{left:-o,right:o,top:o,bottom:-o,near:0,far:2*o}),s.position.copy(t.center).addScaledVector(n.clone().normalize(),o),s.up.set(0,0,1),s.lookAt(t.center),s.updateProjectionMatrix(),s.updateMatrixWorld(),r.setRenderTarget(this.sun),r.render(e,s)}};function yb(i,e){let{uniforms:t}=i.material;for(let[n,s]of Object.entries(e))t[n].value=s}var kA=.004,BA=12e4,zA=.03,HA=[1e6,1e5],VA=300,Rp=[3,9],Mb=1e-5,GA=.02,Au=class{constructor(e,t,n,s){this.shape=e;this.software=s;let{info:r}=e;this.dimension=r.dimension,this.size=r.size,this.ids=e.u32("ids"),this.count=this.ids.length,this.rest=e.f32("points"),this.offsets=e.u32("offsets"),this.facesOf=e.u32("facesOf"),this.faceEnds=e.u32("faceEnds"),this.corners=e.u32("corners"),this.twins=e.u32("twins");let o=e.u32("hollowEnds"),a=e.u32("hollowCorners");e.u32("hollow").forEach((f,d)=>{this.hollow.set(f,a.subarray(o[d],o[d+1]))});let l=this.faceEnds.length-1;this.blockOf=new Uint32Array(l);for(let f=0;f<this.count;f++)this.blockOf.fill(f,this.facesOf[f],this.facesOf[f+1]);this.twinOf=new Int32Array(l).fill(-1);for(let f=0;f<this.twins.length;f++)this.twinOf[this.twins[f]]=f>>1;this.middles=this.means(),this.positions=this.rest.slice(),this.shades=new Float32Array(this.count).fill(.25),this.drawnAs=new Uint32Array(this.positions.length/3),this.shown=new Uint8Array(this.count).fill(1),this.faceShown=new Uint8Array(l),this.geometry.boundingSphere=new Bi,this.edgeGeometry.boundingSphere=this.geometry.boundingSphere;let c=this.dimension===2,h={map:t.texture,side:c?rn:Ms,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},u=c?new qn(h):new _s({...h,flatShading:!0});u instanceof _s&&_b(u,n),this.mesh=new Ot(this.geometry,u),this.cast=new Ot(this.geometry,new qn({colorWrite:!1})),this.cast.frustumCulled=!1,this.lines=new qs(this.edgeGeometry,new zi({color:0,transparent:!0,opacity:c?.55:.35})),this.mesh.frustumCulled=!1,this.lines.frustumCulled=!1,this.section=new Mu(t.texture),this.side=new Uint8Array(this.count),this.ridges=new wu(this,f=>this.isSurvey(f)),this.object.add(this.mesh,this.lines,this.section.object),this.solid.add(this.cast,this.section.cast)}shape;software;object=new jt;solid=new jt;dimension;count;ids;positions;size;visibleFaces=0;rest;offsets;facesOf;faceEnds;corners;twins;hollow=new Map;places=new Map;blockOf;twinOf;middles;geometry=new vt;edgeGeometry=new vt;shades;drawn={count:0,points:new Uint32Array,blocks:new Uint32Array};drawnAs;mesh;cast;lines;section;side;cut=null;plane=new oi;shown;faceShown;ridges;triangleFace=new Uint32Array;seen="";gaps=null;gapLimit=0;withEdges=!1;crowded=!1;clear=!1;ink="#000000";dispose(){this.geometry.dispose(),this.edgeGeometry.dispose(),this.mesh.material.dispose(),this.cast.material.dispose(),this.lines.material.dispose(),this.section.dispose()}set glass(e){let t=this.mesh.material;t.transparent=e,t.opacity=e?.14:1,t.depthWrite=!e,t.needsUpdate=!0,this.section.glass=e,this.clear=e,this.tint(this.ink)}tint(e){this.ink=e,this.lines.material.color.set(this.clear?e:"#000000")}fade(e,t=!1){let n=this.size/e,s=t?0:Math.min(1,(n-Rp[0])/(Rp[1]-Rp[0]));this.lines.visible=this.withEdges&&s>0,this.lines.material.opacity=s*(this.dimension===2?.55:.35),this.section.fade(s)}get isSolid(){return this.dimension===3&&!this.clear}get sphere(){return this.geometry.boundingSphere}get cutBlocks(){return this.section.count}isCut(e){return this.cut!==null&&this.side[e]===2}get planes(){return this.cut?[this.plane]:[]}means(){let e=new Float32Array(3*this.count);for(let t=0;t<this.count;t++){let n=this.offsets[t],s=this.offsets[t+1],r=0,o=0,a=0;for(let c=3*n;c<3*s;c+=3)r+=this.rest[c],o+=this.rest[c+1],a+=this.rest[c+2];let l=Math.max(1,s-n);e.set([r/l,o/l,a/l],3*t)}return e}move(e,t){let n=e.f32("shifts"),s=t.exaggeration;this.dimension===2?pb(this,n,e.f32("turns"),s):mb(this,n,e.i16("turns"),e.info.turnScale/32767,s);let r=e.u32("bent"),o=e.f32("bentShifts"),a=0;for(let u of r)for(let f=3*this.offsets[u];f<3*this.offsets[u+1];f++)this.positions[f]=this.rest[f]+s*o[a++];this.gaps=e.has("gaps")?e.u8("gaps"):null;let{shutDecade:l,steps:c}=e.info,h=u=>Math.ceil((Math.log10(u/Math.max(s,1e-12))-l)*c)+1;this.gapLimit=h(kA),this.gaps&&this.openFaces(this.gapLimit)>BA&&(this.gapLimit=h(zA)),this.bound()}openFaces(e){let t=this.twins.length/2,n=0;for(let s=0;s<t;s++)(this.gaps[s>>1]>>4*(s&1)&15)>=e&&(n+=2);return n}bound(){let e=new wn,t=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0],{positions:s}=this;for(let r=0;r<s.length;r+=3)for(let o=0;o<3;o++){let a=s[r+o];a<t[o]&&(t[o]=a),a>n[o]&&(n[o]=a)}e.min.set(t[0],t[1],t[2]),e.max.set(n[0],n[1],n[2]),e.isEmpty()||e.getBoundingSphere(this.geometry.boundingSphere)}box(){return db(this)}paint(e,t){let{ids:n,shades:s}=this;for(let r=0;r<this.count;r++){let o=(!t.kinds||t.field==="material")&&this.isSurvey(r);s[r]=o?t.terrain:e?t.place(e[r],n[r]):t.tone(n[r])}}isSurvey(e){return this.dimension===3&&this.facesOf[e+1]-this.facesOf[e]>VA}reveal(e,t){let{shown:n,faceShown:s,twins:r,blockOf:o}=this;if(n.fill(1),e.clip&&this.takeAway(e.clip),this.cut=e.clip?.flat?e.clip:null,e.only&&t){let[a,l]=e.only;for(let c=0;c<this.count;c++)t[c]>=a&&t[c]<=l||(n[c]=0)}for(let a=0;a<s.length;a++)s[a]=n[o[a]];for(let a=0;a<r.length;a+=2){let l=r[a],c=r[a+1];if(!s[l]||!s[c]||this.cut&&(this.side[o[l]]===2||this.side[o[c]]===2))continue;let h=a>>1;(this.gaps?this.gaps[h>>1]>>4*(h&1)&15:15)<this.gapLimit&&(s[l]=0,s[c]=0)}this.index(e.edges),this.send(),this.close(e.edges)}clearOf(e,t){if(this.dimension===2)return t;let{positions:n,corners:s,faceEnds:r}=this,o=GA*this.size,[a,l,c]=e,h=new Float32Array(n.length/3);for(let f=0;f<h.length;f++)h[f]=a*n[3*f]+l*n[3*f+1]+c*n[3*f+2]-t;let u=f=>{for(let d=0;d+1<r.length;d++){let p=r[d];for(;p<r[d+1]&&Math.abs(h[s[p]]-f)<o;)p++;if(p===r[d+1])return!1}return!0};for(let f of[0,1,-1,2,-2,4,-4])if(u(2*f*o))return t+2*f*o;return t}takeAway(e){let{shown:t,side:n,middles:s}=this;if(e.flat){bb(this,e,Mb*this.size,n);for(let l=0;l<this.count;l++)n[l]===0&&(t[l]=0);return}let[r,o,a]=e.normal;for(let l=0;l<this.count;l++){let c=r*s[3*l]+o*s[3*l+1]+a*s[3*l+2]-e.at;e.keep*c<0&&(t[l]=0)}}close(e){let{cut:t,side:n,shown:s}=this;for(let o of[this.mesh,this.lines,this.cast])o.material.clippingPlanes=this.planes;if(!t){this.section.clear();return}this.plane.normal.set(...t.normal).multiplyScalar(t.keep),this.plane.constant=Mb*this.size-t.keep*t.at;let r=[];for(let o=0;o<this.count;o++)n[o]===2&&s[o]&&r.push(o);this.section.draw(vb(this,t,r),this.shades,e)}send(){let{count:e,points:t,blocks:n}=this.drawn,s=this.geometry.getAttribute("position"),r=this.geometry.getAttribute("uv"),o=s.array,a=r.array,{positions:l,shades:c}=this;for(let h=0;h<e;h++){let u=3*t[h];o[3*h]=l[u],o[3*h+1]=l[u+1],o[3*h+2]=l[u+2],a[2*h]=c[n[h]]}Tu(s,3*e),Tu(r,2*e)}room(e,t,n){let s=this.geometry.getAttribute("position");if(!s||s.count<e){let r=Math.ceil(1.25*e)+64;this.geometry.dispose(),this.edgeGeometry.dispose();let o=new mn(new Float32Array(3*r),3).setUsage(Tl),a=new mn(new Float32Array(2*r),2).setUsage(Tl);this.geometry.setAttribute("position",o),this.geometry.setAttribute("uv",a),this.edgeGeometry.setAttribute("position",o),this.drawn.points=new Uint32Array(r),this.drawn.blocks=new Uint32Array(r)}for(let[r,o]of[[this.geometry,t],[this.edgeGeometry,n]]){let a=r.getIndex();if(a&&a.count>=o)continue;r.dispose();let l=new mn(new Uint32Array(Math.ceil(1.25*o)+64),1);r.setIndex(l.setUsage(Tl))}}index(e){let{faceShown:t,faceEnds:n,corners:s}=this,r=0,o=0,a=0,l=0;for(let v=0;v<t.length;v++)t[v]&&(l=Math.imul(l,31)+v|0,r++,a+=n[v+1]-n[v],o+=this.hollow.has(v)?this.hollow.get(v).length/3:n[v+1]-n[v]-2);this.visibleFaces=r,this.crowded=r>HA[this.software?1:0]&&this.dimension===3;let c=e&&!this.crowded,h=`${l} ${r} ${c}`;if(this.withEdges=c,h===this.seen)return;this.seen=h,this.room(a,3*o,c?2*a:0);let u=this.geometry.getIndex().array,f=this.edgeGeometry.getIndex().array,d=new Uint32Array(o),{drawn:p,drawnAs:x}=this,m=4294967295;x.fill(m),p.count=0;let g=0,b=0,M=this.dimension===2,y=-1,R=0,S=new Int32Array;for(let v=0;v<t.length;v++){if(!t[v])continue;let w=n[v],C=n[v+1];for(let I=w;I<C;I++){let O=s[I];x[O]===m&&(x[O]=p.count,p.points[p.count]=O,p.blocks[p.count++]=this.blockOf[v])}let P=this.hollow.get(v);if(P){d.fill(v,g/3,(g+P.length)/3);for(let I of P)u[g++]=x[I]}else for(let I=w+1;I+1<C;I++)d[g/3]=v,u[g++]=x[s[w]],u[g++]=x[s[I]],u[g++]=x[s[I+1]];if(c){let I=this.blockOf[v];!M&&I!==y&&(y=I,R=n[this.facesOf[I]],S=this.ridges.at(I));for(let O=w;O<C;O++){if(!M){let z=S[O-R],U=z>>1;if(z!==-1&&t[U]&&(U<v||!(z&1)))continue}f[b++]=x[s[O]],f[b++]=x[s[O+1<C?O+1:w]]}}}this.triangleFace=d,Tu(this.geometry.getIndex(),g),Tu(this.edgeGeometry.getIndex(),b),this.geometry.setDrawRange(0,g),this.edgeGeometry.setDrawRange(0,b)}pick(e){return this.hit(e)?.block??null}hit(e){let t=this.section.pick(e),n=e.intersectObject(this.mesh,!1).find(r=>!this.isAway(r.point));if(t&&(!n||t.distance<n.distance))return{block:t.block,point:e.ray.at(t.distance,new N)};if(!n||n.faceIndex===void 0||n.faceIndex===null)return null;let s=this.blockOf[this.triangleFace[n.faceIndex]];return s===void 0?null:{block:s,point:n.point}}cornersOf(e){let t=[];for(let n=this.offsets[e];n<this.offsets[e+1];n++)t.push(new N().fromArray(this.positions,3*n));return t}placeOf(e){return this.places.size===0&&this.ids.forEach((t,n)=>this.places.set(t,n)),this.places.get(e)??-1}isShown(e){return this.shown[e]===1}isAway(e){return this.cut!==null&&this.plane.distanceToPoint(e)<0}outline(e){let t=[];for(let n=this.facesOf[e];n<this.facesOf[e+1];n++){let s=this.faceEnds[n],r=this.faceEnds[n+1];for(let o=s;o<r;o++)for(let a of[this.corners[o],this.corners[o+1<r?o+1:s]])t.push(...this.positions.subarray(3*a,3*a+3))}return Float32Array.from(t)}};function Tu(i,e){i.clearUpdateRanges(),i.addUpdateRange(0,e),i.needsUpdate=!0}function wb(i){return i.reduce((e,[t,n],s)=>{let[r,o]=i[(s+1)%i.length];return e+t*o-r*n},0)}function WA(i,e){let t=i;return e.forEach(([n,s],r)=>{let[o,a]=e[(r+1)%e.length],l=([h,u])=>(o-n)*(u-s)-(a-s)*(h-n),c=[];t.forEach((h,u)=>{let f=t[(u+1)%t.length],[d,p]=[l(h),l(f)];if(d>=0&&c.push(h),d>=0!=p>=0){let x=d/(d-p);c.push([h[0]+x*(f[0]-h[0]),h[1]+x*(f[1]-h[1])])}}),t=c}),t}function Sb(i,e,t,n){let{rest:s,corners:r,faceEnds:o}=i,a=C=>Array.from(r.subarray(o[C],o[C+1])),[l,c]=[a(e),a(t)],h=new N().fromArray(s,3*l[1]).sub(new N().fromArray(s,3*l[0])).normalize(),u=n.clone().cross(h),f=C=>{let P=new N().fromArray(s,3*C).sub(new N().fromArray(s,3*l[0]));return[h.dot(P),u.dot(P)]},[d,p]=[l.map(f),c.map(f)],x=WA(d,wb(p)<0?p.reverse():p),m=.5*wb(x);if(x.length<3||!(m>0))return null;let g=C=>Math.abs(d[1][0]*d[C][1]-d[1][1]*d[C][0]),b=2;for(let C=3;C<d.length;C++)g(C)>g(b)&&(b=C);let[[M,y],[R,S]]=[d[1],d[b]],v=M*S-y*R,w=x.flatMap(([C,P])=>[(C*S-P*R)/v,(M*P-y*C)/v]);return{size:m,piece:{base:[l[0],l[1],l[b]],shares:w}}}var XA=15,Eb=8,Tb="#9a9a9a",Ab=.002,Ru=class{object;known=new WeakMap;constructor(){this.object=new Ot(new vt,new _s({vertexColors:!0,side:rn,flatShading:!0})),this.object.frustumCulled=!1,this.object.visible=!1,this.object.renderOrder=2}draw(e,t,n,s){if(this.object.visible=!1,e==="")return[];let r=this.known.get(t);if(!r){let h=t.dimension===3?qA(t):YA(t);r={joints:h,sets:JA(h,t.dimension)},this.known.set(t,r)}let o=e==="set"?r.sets:KA(r.joints,t.dimension,n,s),a=[],l=[];for(let{note:h,joints:u}of o){let f=u.filter(g=>t.isShown(g.blocks[0])&&t.isShown(g.blocks[1])),d=a.length,p=f.filter(g=>!g.piece).map(g=>g.blocks);for(let g of xu(t,p).points)a.push(g);let x=t.dimension===3?jA:ZA;for(let{piece:g}of f)g&&x(t,g,a);let m=new qe(h.colour).toArray();for(let g=d;g<a.length;g+=3)l.push(...m)}let{geometry:c}=this.object;return c.dispose(),c.setAttribute("position",new rt(a,3)),c.setAttribute("color",new rt(l,3)),c.deleteAttribute("normal"),t.dimension===2&&c.setAttribute("normal",new rt(a.map((h,u)=>u%3===2?1:0),3)),this.object.material.clippingPlanes=t.planes,this.object.visible=a.length>0,o.map(h=>h.note)}};function Rb(i,e){let{rest:t,corners:n,faceEnds:s}=i,[r,o,a,l]=[new N,new N,new N,new N];o.fromArray(t,3*n[s[e]]);for(let c=s[e]+1;c+1<s[e+1];c++)a.fromArray(t,3*n[c]).sub(o),l.fromArray(t,3*n[c+1]).sub(o),r.add(a.cross(l));return r}function qA(i){let{twins:e,blockOf:t}=i,n=[],s=new Set(e);for(let r=0;r<e.length;r+=2){let[o,a]=[e[r],e[r+1]],l=Rb(i,o),c=.5*l.length();c>0&&n.push({blocks:[t[o],t[a]],axis:l.normalize(),size:c})}return[...n,...$A(i,s)]}function $A(i,e){let{rest:t,corners:n,faceEnds:s,blockOf:r,size:o}=i,a=Ab*o,l=new Map,c=(x,m,g)=>[...x.toArray().map((b,M)=>Math.round(b/.02)+g[M]),Math.round(m/(4*a))+g[3]].join(" "),h=[];for(let x=0;x+1<s.length;x++){if(e.has(x))continue;let m=Rb(i,x);if(!(m.length()>a*a))continue;m.normalize();let g=Array.from(n.subarray(s[x],s[x+1]),v=>Array.from(t.subarray(3*v,3*v+3))),[b,M]=[Math.min,Math.max].map(v=>[0,1,2].map(w=>v(...g.map(C=>C[w])))),y={face:x,normal:m,off:m.dot(new N(...g[0])),low:b,high:M};h.push(y);let R=c(m,y.off,[0,0,0,0]),S=l.get(R);S?S.push(y):l.set(R,[y])}let u=[-1,0,1],f=u.flatMap(x=>u.flatMap(m=>u.flatMap(g=>u.map(b=>[x,m,g,b])))),d=[],p=new N;for(let x of h){p.copy(x.normal).negate();for(let m of f)for(let g of l.get(c(p,-x.off,m))??[]){let[b,M]=[x.face,g.face];if(M<b||r[b]===r[M]||Math.abs(x.off+g.off)>2*a||[0,1,2].some(R=>x.low[R]>g.high[R]+a||g.low[R]>x.high[R]+a))continue;let y=Sb(i,b,M,x.normal);y&&y.size>a*o&&d.push({blocks:[r[b],r[M]],axis:x.normal.clone(),...y})}}return d}function YA(i){let{rest:e,corners:t,faceEnds:n,blockOf:s,size:r}=i,o=Ab*r,a=new Map,l=(h,u,f)=>`${Math.round(Math.atan2(h.direction[1],h.direction[0])/.01)+u} ${Math.round(h.off/(4*o))+f}`,c=[];for(let h=0;h+1<n.length;h++)for(let u=n[h];u<n[h+1];u++){let[f,d]=[t[u],t[u+1<n[h+1]?u+1:n[h]]],[p,x]=[e[3*d]-e[3*f],e[3*d+1]-e[3*f+1]],m=Math.hypot(p,x);if(!(m>o))continue;let g=p>1e-6*m||Math.abs(p)<=1e-6*m&&x>0?1:-1;[p,x]=[g*p/m,g*x/m];let b=w=>p*e[3*w]+x*e[3*w+1],M={block:s[h],corners:[f,d],ends:[b(f),b(d)],direction:[p,x],off:p*e[3*f+1]-x*e[3*f]},[y,R]=[Math.min(...M.ends),Math.max(...M.ends)];for(let w=-1;w<=1;w++)for(let C=-1;C<=1;C++)for(let P of a.get(l(M,w,C))??[]){let I=Math.max(y,Math.min(...P.ends)),O=Math.min(R,Math.max(...P.ends));if(P.block===M.block||O-I<=o||Math.abs(P.off-M.off)>2*o)continue;let z=U=>(U-M.ends[0])/(M.ends[1]-M.ends[0]);c.push({blocks:[M.block,P.block],axis:new N(p,x,0),size:O-I,piece:{base:[f,d],shares:[z(I),z(O)]}})}let S=l(M,0,0),v=a.get(S);v?v.push(M):a.set(S,[M])}return c}function Pp(i){let{low:e,high:t}=i.shape.info;return Math.min(.025*i.size,Math.hypot(t[0]-e[0],t[1]-e[1])/500)}function ZA(i,{base:e,shares:t},n){let{positions:s}=i,r=(x,m)=>(1-t[x])*s[3*e[0]+m]+t[x]*s[3*e[1]+m],[o,a,l,c]=[r(0,0),r(0,1),r(1,0),r(1,1)],h=Math.hypot(l-o,c-a)||1,u=Pp(i),[f,d]=[-(c-a)/h*u,(l-o)/h*u],p=.35;n.push(o-f,a-d,p,l-f,c-d,p,l+f,c+d,p,o-f,a-d,p,l+f,c+d,p,o+f,a+d,p)}function jA(i,{base:e,shares:t},n){let{positions:s}=i,[r,o,a]=e,l=c=>{for(let h=0;h<3;h++){let u=s[3*r+h];n.push(u+t[2*c]*(s[3*o+h]-u)+t[2*c+1]*(s[3*a+h]-u))}};for(let c=1;2*c+2<t.length;c++)[0,c,c+1].forEach(l)}function JA(i,e){let t=Math.cos(Jn.degToRad(XA)),n=[];for(let o of[...i].sort((a,l)=>l.size-a.size)){let a,l=t;for(let c of n){let h=Math.abs(c.sum.dot(o.axis))/c.sum.length();h>l&&([a,l]=[c,h])}a||(a={sum:new N,size:0,joints:[]},n.push(a)),a.sum.addScaledVector(o.axis,a.sum.dot(o.axis)<0?-o.size:o.size),a.size+=o.size,a.joints.push(o)}n.sort((o,a)=>a.size-o.size);let s=n.slice(0,Eb).map((o,a)=>({note:{text:`set ${a+1}: ${QA(o.sum,e)}, ${Cp(o.size,e)}`,colour:Yr(a)},joints:o.joints})),r=n.slice(Eb);if(r.length>0){let o=r.reduce((a,l)=>a+l.size,0);s.push({note:{text:`other directions, ${Cp(o,e)}`,colour:Tb},joints:r.flatMap(a=>a.joints)})}return s}function KA(i,e,t,n){if(!t||!n)return[];let s=Math.round(Math.sqrt(t.pairs.length)),r=new Map;for(let o of i){let[a,l]=o.blocks.map(u=>n[u]),c=t.pairs[a*s+l]??-1,h=r.get(c)??{size:0,joints:[]};h.size+=o.size,h.joints.push(o),r.set(c,h)}return[...r].sort(([o],[a])=>o-a).map(([o,{size:a,joints:l}])=>({note:{text:`${t.interfaces[o]??"no law"}: ${Cp(a,e)}`,colour:o<0?Tb:Yr(o)},joints:l}))}function QA(i,e){let t=o=>Math.round(Jn.radToDeg(o));if(e===2)return`${(t(Math.atan2(i.y,i.x))+180)%180}\xB0 from x`;let n=i.clone().normalize();n.z<0&&n.negate();let s=t(Math.acos(Math.min(1,n.z))),r=(t(Math.atan2(n.x,n.y))+360)%360;return`${String(s).padStart(2,"0")}\xB0/${s===0?"\u2013":`${String(r).padStart(3,"0")}\xB0`}`}function Cp(i,e){return`${kt(i,3)} ${e===3?"m\xB2":"m"}`}var Ip={held:{name:"held",colour:"#2f7bd9"},roller:{name:"rollers",colour:"#2aa7a0"},held_along:{name:"held along the face",colour:"#6b7fd7"},moved:{name:"moved",colour:"#e07b1a"},viscous:{name:"viscous",colour:"#8a5cc4"},loaded:{name:"loaded",colour:"#d0342c"}},Cb="#c2187a",Pb="#1f8fe0",e2=400,Cu=class{object=new jt;faces;arrows;surface;known=new WeakMap;reach=new wn;constructor(){this.faces=new Ot(new vt,new qn({vertexColors:!0,side:rn,transparent:!0,opacity:.8,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-2}));let e={depthTest:!1,transparent:!0};this.arrows={plane:new wr(!0,e),space:new wr(!1,e)};for(let t of Object.values(this.arrows))t.colour=Cb;this.surface=new Ot(new vt,new qn({color:Pb,side:rn,transparent:!0,opacity:.35,depthWrite:!1}));for(let t of[this.faces,this.surface])t.frustumCulled=!1,t.visible=!1,t.renderOrder=2;this.object.add(this.faces,this.surface,this.arrows.plane.object,this.arrows.space.object)}places(e,t){let n=this.known.get(t);if(n)return n;n=[];let{origin:s}=t.shape.info,r=new N;return e.faces.forEach(({blocks:o,centres:a},l)=>{o.forEach((c,h)=>{let u=t.placeOf(c);if(u<0)return;let f=a[h];r.set(f[0]-s[0],f[1]-s[1],f[2]-s[2]);let d=-1,p=1/0;for(let x=t.facesOf[u];x<t.facesOf[u+1];x++){let m=o2(t,x,r);m<p&&([d,p]=[x,m])}d>=0&&n.push({condition:l,item:h,block:u,face:d})})}),this.known.set(t,n),n}drawFaces(e,t){if(this.faces.visible=!1,!e||t.dimension===2)return[];let n=[],s=[],r=e.faces.map(u=>new qe(Ip[u.kind].colour).toArray()),{positions:o,corners:a,faceEnds:l}=t;for(let{condition:u,block:f,face:d}of this.places(e,t)){if(!t.isShown(f))continue;let p=l[d];for(let x=p+1;x+1<l[d+1];x++)for(let m of[a[p],a[x],a[x+1]])n.push(o[3*m],o[3*m+1],o[3*m+2]),s.push(...r[u])}let{geometry:c}=this.faces;c.dispose(),c.setAttribute("position",new rt(n,3)),c.setAttribute("color",new rt(s,3)),this.faces.visible=n.length>0,this.faces.material.clippingPlanes=t.planes;let h=[];for(let u of Object.keys(Ip)){let f=e.faces.filter(g=>g.kind===u),d=f.reduce((g,b)=>g+b.count,0);if(d===0)continue;let p=f.some(g=>g.blocks.length===0)?", too many to draw":"",{name:x,colour:m}=Ip[u];h.push({text:`${x}: ${d} face${d===1?"":"s"}${p}`,colour:m})}return h}drawLoads(e,t,n,s){let r=t.dimension===2,o=r?this.arrows.plane:this.arrows.space;for(let d of Object.values(this.arrows))d.clear();if(this.reach.makeEmpty(),!e)return[];let a=[...n2(e,t),...this.tractions(e,t)],l=new Map;for(let{kind:d,unit:p,vector:x}of a){let m=l.get(d),g=x.length();m&&m.count++,(!m||g>m.size)&&l.set(d,{size:g,unit:p,count:m?m.count:1})}let c=[],h=[],u=new N,f=new N;for(let{kind:d,block:p,place:x,vector:m}of a){let{size:g}=l.get(d);!(g>0)||r&&d==="moment"||!t.isShown(p)||(f.copy(m).divideScalar(g),u.copy(x).add(n(p,new N)),u.addScaledVector(f,-s),c.push(...u.toArray()),this.reach.expandByPoint(u),h.push(...f.toArray()))}return c.length>0&&o.draw(new Float32Array(c),new Float32Array(h),1,s),[...l].map(([d,{size:p,unit:x,count:m}])=>({text:`${m===1?d:`${m} ${t2[d]??d}, up to`} ${un(p,x,3)}`,colour:Cb}))}tractions(e,t){if(t.dimension===2)return[];let n=this.places(e,t).filter(o=>e.faces[o.condition].tractions.length>0),s=Math.max(1,Math.ceil(n.length/e2)),{origin:r}=t.shape.info;return n.filter((o,a)=>a%s===0).map(({condition:o,item:a,block:l})=>{let{centres:c,tractions:h}=e.faces[o],u=new N(...c[a]).sub(new N(...r));return{kind:"traction",unit:"Pa",block:l,place:u,vector:new N(...h[a])}})}drawWater(e,t,n){this.surface.visible=!1;let s=e?.standing.find(([l])=>l===n)??e?.standing[0],r=s&&s[1]!==null?e.water[s[1]]:void 0;if(!r)return[];let o=t.dimension===2,a=[];for(let l of r.parts??[r])a.push(...l.grid?i2(l.grid,t):s2(l,t));return this.surface.geometry.dispose(),this.surface.geometry.setAttribute("position",new rt(a,3)),this.surface.material.opacity=o?.9:.35,this.surface.visible=!0,[{text:`water table ${r.name}`,colour:Pb}]}},t2={force:"forces",moment:"moments",pressure:"arrows of pressure",acceleration:"accelerations",traction:"faces loaded"};function n2(i,e){let{origin:t}=e.shape.info;return i.loads.flatMap(({kind:n,unit:s,block:r,at:o,vector:a})=>{let l=e.placeOf(r),c=new N(...o).sub(new N(...t));return e.dimension===2&&(c.z=0),l<0?[]:[{kind:n,unit:s,block:l,place:c,vector:new N(...a)}]})}function i2([i,e,t],n){let{origin:s}=n.shape.info,r=(a,l)=>[i[a]-s[0],e[l]-s[1],t[l*i.length+a]-s[2]],o=[];for(let a=0;a+1<e.length;a++)for(let l=0;l+1<i.length;l++){let[c,h,u,f]=[r(l,a),r(l+1,a),r(l+1,a+1),r(l,a+1)];o.push(...c,...h,...u,...c,...u,...f)}return o}function s2(i,e){let{low:t,high:n,origin:s}=e.shape.info,r=e.dimension===2,o=(b,M)=>i.along[0]*(b+s[0])+i.along[1]*(M+s[1]),a=r?[t[0]+s[0],n[0]+s[0]]:[0,1,2,3].map(b=>o(b&1?n[0]:t[0],b&2?n[1]:t[1])),[l,c]=[Math.min(...a),Math.max(...a)];r&&i.within&&([l,c]=[Math.max(l,i.within[0][0]),Math.min(c,i.within[1][0])]);let h=r2(i.points,l,c),u=[];if(r){let b=Pp(e);for(let M=0;M+1<h.length;M++){let[[y,R],[S,v]]=[h[M],h[M+1]].map(([w,C])=>[w-s[0],C-s[1]]);u.push(y,R-b,.45,S,v-b,.45,S,v+b,.45,y,R-b,.45,S,v+b,.45,y,R+b,.45)}return u}let[f,d]=i.along,p=.5*Math.hypot(n[0]-t[0],n[1]-t[1]),x=[s[0]+.5*(t[0]+n[0]),s[1]+.5*(t[1]+n[1])],m=-d*x[0]+f*x[1],g=([b,M],y)=>{let R=m+y*p;return[f*b-d*R-s[0],d*b+f*R-s[1],M-s[2]]};for(let b=0;b+1<h.length;b++){let[M,y]=[h[b],h[b+1]];u.push(...g(M,-1),...g(y,-1),...g(y,1),...g(M,-1),...g(y,1),...g(M,1))}return u}function r2(i,e,t){let n=s=>{let r=i.findIndex(h=>h[0]>s);if(r===0)return i[0][1];if(r<0)return i.at(-1)[1];let[[o,a],[l,c]]=[i[r-1],i[r]];return a+(c-a)*(s-o)/(l-o)};return[[e,n(e)],...i.filter(s=>s[0]>e&&s[0]<t),[t,n(t)]]}function o2(i,e,t){let{rest:n,corners:s,faceEnds:r}=i,[o,a]=[r[e],r[e+1]],l=new N().fromArray(n,3*s[o]),c=new N,[h,u]=[new N,new N];for(let f=o+1;f+1<a;f++)h.fromArray(n,3*s[f]).sub(l),u.fromArray(n,3*s[f+1]).sub(l),c.add(h.cross(u));return Math.abs(c.normalize().dot(h.subVectors(t,l)))}var Ib=250,Pu=class{object=Q("div.loading",{role:"status","aria-live":"polite",hidden:!0});all=new Set;timer=0;begin(e,t="bytes",n=null){let s={what:e,got:0,of:n,unit:t,since:performance.now()};return this.all.add(s),this.timer||(this.timer=window.setInterval(()=>this.say(),Ib/2)),s}end(e){this.all.delete(e),!(this.all.size>0)&&(clearInterval(this.timer),this.timer=0,this.object.hidden=!0)}async announce(e){let t=this.begin(e);return this.object.hidden=!1,this.write(t),await new Promise(n=>setTimeout(n,30)),t}say(){let e=performance.now(),[t]=[...this.all].filter(n=>e-n.since>Ib).sort((n,s)=>(s.of??0)-(n.of??0)||n.since-s.since);t&&(this.object.hidden=!1,this.write(t))}write({what:e,got:t,of:n,unit:s,since:r}){let o=Math.floor((performance.now()-r)/1e3),a=h=>s==="bytes"?(h/1e6).toFixed(h<1e7?1:0):String(h),l=n===null?o>1?`, ${o} s`:"":`: ${a(t)} of ${a(n)} ${s==="bytes"?"MB":"frames"}`,c=n===null?null:Q("progress",{max:n,value:t});this.object.replaceChildren(Q("span",{},`${e}${l}`),...c?[c]:[])}},a2={summary:"the run",shape:"the shapes of the blocks",frame:"the places of the blocks",contacts:"the contacts",cracks:"the cracks",bolts:"the bolts",stress:"the stresses",conditions:"the conditions",names:"the names",table:"the histories"};function Lb(i){let[e,t=""]=i.split(/[/?](.*)/s),n=new URLSearchParams(i.split("?")[1]??"").get("name");return n?`Reading ${n}`:e==="block"?`Reading block ${t.split("/")[1]??""}`:`Reading ${a2[e]??i}`}var l2={f32:Float32Array,f64:Float64Array,u32:Uint32Array,i16:Int16Array,u8:Uint8Array},Nl=class{info;bytes;arrays=new Map;constructor(e){let t=new DataView(e).getUint32(0,!0),n=JSON.parse(new TextDecoder().decode(new Uint8Array(e,4,t)));this.info=n.info,this.bytes=e.byteLength;let s=Math.ceil((4+t)/8)*8;for(let r of n.arrays)this.arrays.set(r.name,new l2[r.type](e,s+r.at,r.length))}has(e){return this.arrays.has(e)}f32(e){return this.get(e)}f64(e){return this.get(e)}u32(e){return this.get(e)}i16(e){return this.get(e)}u8(e){return this.get(e)}get(e){let t=this.arrays.get(e);if(!t)throw new Error(`the answer has no array ${e}`);return t}};var Qn=class extends Error{constructor(t,n){super(t);this.what=t;this.hint=n}what;hint},Iu=class{constructor(e,t){this.run=e;this.loading=t}run;loading;json(e){return this.told(e,async t=>await t.json())}packet(e){return this.told(e,async(t,n)=>new Nl(await c2(t,n)))}async told(e,t){let n=this.loading.begin(Lb(e));try{return await t(await this.ask(e),n)}finally{this.loading.end(n)}}file(e){return`api/${this.run}/file/${e}`}async ask(e){let t;try{t=await fetch(`api/${this.run}/${e}`)}catch{throw new Qn("The viewer does not answer any more.","Start it again: riprap view RUN")}if(t.ok)return t;let n=await t.json().catch(()=>({}));throw new Qn(n.what??`${e}: ${t.status}`,n.hint??"Reload the page.")}};async function c2(i,e){let t=Number(i.headers.get("content-length"));if(!i.body||!(t>1e6))return i.arrayBuffer();e.of=t;let n=new Uint8Array(t),s=i.body.getReader();for(;;){let{done:r,value:o}=await s.read();if(r)break;n.set(o,e.got),e.got+=o.length}if(e.got!==t)throw new Qn("The answer of the viewer was cut off.","Reload the page.");return n.buffer}var Lu=class{constructor(e){this.answers=e}answers;async json(e){return JSON.parse(new TextDecoder().decode(await this.bytes(e)))}async packet(e){return new Nl(await this.bytes(e))}file(){}async bytes(e){let t=this.answers.get(e);if(typeof t=="object"&&(t=this.answers.get(t.as)),typeof t!="string")throw new Qn("The report does not hold this.","Look at the run itself: riprap view RUN");let n=Uint8Array.from(atob(t),r=>r.charCodeAt(0)),s=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(s).arrayBuffer()}};function Lp(i,e){let t=i.blocks.findLast(n=>n.first<=e);return!t||e>=t.first+(t.count??1)?"":t.from===void 0?t.name:`${t.name}.${t.from+e-t.first}`}async function Db(i,e,t){let n=await i.motion(e);return(await i.shape(n.info.shape,e)).u32("ids").indexOf(t)}async function Nb(i,e,t){let n=await Db(i,e,t);if(n<0)throw new Qn(`there is no block ${t} in this frame`,"It was split, cut or removed.");let{held:s,names:r,fields:o}=i.summary,a=await Promise.all((r??[]).map(async h=>{let u=o.find(d=>d.name===h)?.components??1;if(s.vectors.includes(h)){let d=await i.vectors(e,h);return{name:h,unit:d.info.unit,values:[...d.f32("values").subarray(3*n,3*n+u)]}}let f=await i.field(e,h).catch(()=>null);return{name:h,unit:f?.info.unit??"",values:f?[f.f32("values")[n]]:[]}})),{names:l}=i,c=l.groups.filter(h=>h.blocks.some(([u,f])=>u<=t&&t<=f)).map(h=>h.name);return{block:t,name:Lp(l,t),groups:c,frame:e,columns:a.filter(h=>h.values.length>0)}}async function Ub(i,e,t,n){let s=[],r="";for(let o=0;o<i.frames;o++){let a=await Db(i,o,e),l=a<0?null:await i.field(o,t).catch(()=>null);r=l?.info.unit??r;let c=l?.f32("values")[a];s.push(c!==void 0&&Number.isFinite(c)?c:null)}n(s,r)}var h2=4e8;function Dp(i){let e=un(i.time,"s");if(!i.still)return e;let t=[i.phase,`step ${i.step}`].filter(Boolean);return(i.time===0?t:[e,...t]).join(", ")}var Du=class i{constructor(e,t){this.source=e;this.summary=t}source;summary;memory=new Map;held=0;ranges=new Map;conditions=null;names={blocks:[],groups:[]};static async open(e){return new i(e,await e.json("summary"))}get frames(){return this.summary.times?.length??0}async refresh(){let e=await this.source.json("summary");if(e.problem&&!this.summary.problem)throw new Qn(e.problem.what,e.problem.hint);let t=this.summary.manifest,n=!e.problem&&(e.manifest.started!==t?.started||e.manifest.input_hash!==t.input_hash);return n&&(this.memory.clear(),this.held=0),e.times?.length!==this.summary.times?.length&&this.ranges.clear(),this.summary=e,n}async readModel(){[this.conditions,this.names]=await Promise.all([this.source.json("conditions").catch(()=>null),this.source.json("names").catch(()=>this.names)])}get hasStress(){let{held:e,fields:t}=this.summary;return e?e.stress:(t??[]).some(n=>n.name==="stress_shear")}called(e){return Lp(this.names,e)||`block ${e}`}motion(e){return this.packet(`frame/${e}`)}shape(e,t){return this.packet(`shape/${t}`,`shape ${e}`)}field(e,t){return this.packet(`field/${e}?name=${encodeURIComponent(t)}`)}vectors(e,t){return this.packet(`vectors/${e}?name=${encodeURIComponent(t)}`)}contacts(e){return this.packet(`contacts/${e}`)}cracks(e){return this.packet(`cracks/${e}`)}bolts(e){return this.packet(`bolts/${e}`)}stress(e){return this.packet(`stress/${e}`)}block(e,t){return this.summary.held?Nb(this,e,t):this.source.json(`block/${e}/${t}`)}async history(e,t,n){let s=[];if(this.summary.held)return Ub(this,e,t,n);let r=24;for(let o=0;o<this.frames;o+=r){let a=await this.source.json(`history/${e}?name=${encodeURIComponent(t)}&from=${o}&count=${r}`);if(s.push(...a.values.map(l=>typeof l=="number"?l:null)),!n(s,a.unit))return}}hasField(e){let t=e.replace(/\.(x|y|z|magnitude)$/,"");return(this.summary.fields??[]).some(n=>n.name===t)}range(e){let t=this.ranges.get(e);if(t!==void 0)return t;let n=this.readRange(e);return this.ranges.set(e,n),n.catch(()=>this.ranges.delete(e)),n}async readRange(e){let t={range:null,most:null},n=24,s=this.summary.held!==void 0;for(let r=0;r<(s?1:this.frames);r+=n){let o=s?"":`&from=${r}&count=${n}`,a=await this.source.json(`range?name=${s?e:encodeURIComponent(e)}${o}`);t.range=Nu(t.range,a.range),t.most=Nu(t.most,a.most??a.range)}return t}async table(e){let t=await this.source.packet(`table/${e}`),n=t.info.columns,s=n.map((l,c)=>c).filter(l=>!["time","step"].includes(n[l].name)),r=l=>{let c=n.findIndex(h=>h.name===l);return c<0?new Float64Array:t.f64(String(c))},o=r("time"),a=o.length>1&&o.every(l=>l===o[0]);return{names:s.map(l=>n[l].name),units:s.map(l=>n[l].unit),columns:s.map(l=>t.f64(String(l))),x:a?r("step"):o,bySteps:a}}moments(){let e=0,{steps:t,phases:n}=this.summary;return(this.summary.times??[]).map((s,r,o)=>{e=r>0&&o[r-1]===s?e+1:0;let a=e>0||o[r+1]===s;return{time:s,nth:e,step:t[r]??0,phase:n[r]??"",still:a}})}saidAt(e){let t=this.moments()[e];return t?Dp(t):""}frameAt(e){let t=this.moments(),n=1e-9*Math.abs(e.time),s=0,r=t.length;for(;s<r;){let o=s+r>>1,{time:a,nth:l}=t[o];(Math.abs(a-e.time)<=n?l<=e.nth:a<e.time)?s=o+1:r=o}return Math.max(0,s-1)}packet(e,t=e){let n=this.memory.get(t);if(n)return this.memory.delete(t),this.memory.set(t,n),n.answer;let s=this.source.packet(e),r={answer:s,bytes:0};return this.memory.set(t,r),s.then(o=>{r.bytes=o.bytes,this.held+=o.bytes;for(let[a,l]of this.memory){if(this.held<h2)break;l!==r&&l.bytes>0&&(this.memory.delete(a),this.held-=l.bytes)}},()=>this.memory.delete(t)),s}};function Nu(i,e){return i&&e?[Math.min(i[0],e[0]),Math.max(i[1],e[1])]:i??e}function Sr(i){return i instanceof Qn?{what:i.what,hint:i.hint}:{what:i instanceof Error?i.message:String(i),hint:"Reload the page."}}var Fb={type:"change"},Up={type:"start"},kb={type:"end"},Uu=new Gs,Ob=new oi,u2=Math.cos(70*Jn.DEG2RAD),Cn=new N,gi=2*Math.PI,Rt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Np=1e-6,Fu=class extends xl{constructor(e,t=null){super(e,t),this.state=Rt.NONE,this.target=new N,this.cursor=new N,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Vi.ROTATE,MIDDLE:Vi.DOLLY,RIGHT:Vi.PAN},this.touches={ONE:ts.ROTATE,TWO:ts.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new N,this._lastQuaternion=new Ei,this._lastTargetPosition=new N,this._quat=new Ei().setFromUnitVectors(e.up,new N(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new qo,this._sphericalDelta=new qo,this._scale=1,this._panOffset=new N,this._rotateStart=new we,this._rotateEnd=new we,this._rotateDelta=new we,this._panStart=new we,this._panEnd=new we,this._panDelta=new we,this._dollyStart=new we,this._dollyEnd=new we,this._dollyDelta=new we,this._dollyDirection=new N,this._mouse=new we,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=d2.bind(this),this._onPointerDown=f2.bind(this),this._onPointerUp=p2.bind(this),this._onContextMenu=_2.bind(this),this._onMouseWheel=x2.bind(this),this._onKeyDown=b2.bind(this),this._onTouchStart=v2.bind(this),this._onTouchMove=y2.bind(this),this._onMouseDown=m2.bind(this),this._onMouseMove=g2.bind(this),this._interceptControlDown=M2.bind(this),this._interceptControlUp=w2.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Rt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Fb),this.update(),this.state=Rt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Cn.copy(t).sub(this.target),Cn.applyQuaternion(this._quat),this._spherical.setFromVector3(Cn),this.autoRotate&&this.state===Rt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=gi:n>Math.PI&&(n-=gi),s<-Math.PI?s+=gi:s>Math.PI&&(s-=gi),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Cn.setFromSpherical(this._spherical),Cn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Cn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Cn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new N(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new N(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Cn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Uu.origin.copy(this.object.position),Uu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Uu.direction))<u2?this.object.lookAt(this.target):(Ob.setFromNormalAndCoplanarPoint(this.object.up,this.target),Uu.intersectPlane(Ob,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Np||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Np||this._lastTargetPosition.distanceToSquared(this.target)>Np?(this.dispatchEvent(Fb),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?gi/60*this.autoRotateSpeed*e:gi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Cn.setFromMatrixColumn(t,0),Cn.multiplyScalar(-e),this._panOffset.add(Cn)}_panUp(e,t){this.screenSpacePanning===!0?Cn.setFromMatrixColumn(t,1):(Cn.setFromMatrixColumn(t,0),Cn.crossVectors(this.object.up,Cn)),Cn.multiplyScalar(e),this._panOffset.add(Cn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Cn.copy(s).sub(this.target);let r=Cn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(gi*this._rotateDelta.x/t.clientHeight),this._rotateUp(gi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(gi*this._rotateDelta.x/t.clientHeight),this._rotateUp(gi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new we,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function f2(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function d2(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function p2(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(kb),this.state=Rt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function m2(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Vi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Rt.DOLLY;break;case Vi.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Rt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Rt.ROTATE}break;case Vi.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Rt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Rt.PAN}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(Up)}function g2(i){switch(this.state){case Rt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Rt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Rt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function x2(i){this.enabled===!1||this.enableZoom===!1||this.state!==Rt.NONE||(i.preventDefault(),this.dispatchEvent(Up),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(kb))}function b2(i){this.enabled!==!1&&this._handleKeyDown(i)}function v2(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case ts.ROTATE:if(this.enableRotate===!1){this.state=Rt.NONE;break}this._handleTouchStartRotate(i),this.state=Rt.TOUCH_ROTATE;break;case ts.PAN:if(this.enablePan===!1){this.state=Rt.NONE;break}this._handleTouchStartPan(i),this.state=Rt.TOUCH_PAN;break;default:this.state=Rt.NONE}break;case 2:switch(this.touches.TWO){case ts.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Rt.TOUCH_DOLLY_PAN;break;case ts.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Rt.TOUCH_DOLLY_ROTATE;break;default:this.state=Rt.NONE}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(Up)}function y2(i){switch(this._trackPointer(i),this.state){case Rt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Rt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Rt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Rt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Rt.NONE}}function _2(i){this.enabled!==!1&&i.preventDefault()}function M2(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function w2(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var S2=[15e5,15e4],E2=2e4,T2=220,Ou=class{constructor(e,t){this.host=e;this.dimension=t;if(!document.createElement("canvas").getContext("webgl2"))throw new Qn("This browser does not support WebGL 2.","Switch on its hardware acceleration or try another browser. Without it: riprap plot RUN draws pictures.");let n=A2();this.software=n,this.renderer=new cu({antialias:!n,preserveDrawingBuffer:!0}),this.renderer.localClippingEnabled=!0,this.renderer.setPixelRatio(n?1:Math.min(window.devicePixelRatio,2)),this.canvas=this.renderer.domElement,this.canvas.tabIndex=0,this.canvas.setAttribute("aria-label","the blocks"),e.append(this.canvas),this.shading=new Eu(this.renderer,n),this.scene.add(this.sky,this.light,this.axes),this.camera=this.makeCamera(),this.controls=this.makeControls(),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}host;dimension;canvas;scene=new qa;renderer;camera;controls;onMove=null;onDrawn=null;onDraw=null;standing=0;moving=!1;shadowed=null;shading;software;light=new ml(16777215,1.5);sky=new dl(16777215,13684944,1.35);due=!1;up="z";following=!1;axes=new jt;box=new wn(new N(-1,-1,-1),new N(1,1,1));set background(e){this.scene.background=new qe(e),this.redraw()}setDimension(e,t){e===this.dimension&&t===this.up||(this.dimension=e,this.up=t,this.controls.dispose(),this.camera=this.makeCamera(),this.controls=this.makeControls(),this.resize())}makeCamera(){if(this.dimension===2)return new Ri(-1,1,1,-1,.1,1e3);let e=new pn(32,1,.01,1e3);return e.up.set(0,this.up==="y"?1:0,this.up==="y"?0:1),e}makeControls(){let e=new Fu(this.camera,this.canvas);return e.zoomToCursor=!0,e.screenSpacePanning=!0,this.dimension===2&&(e.enableRotate=!1,e.mouseButtons={LEFT:Vi.PAN,MIDDLE:Vi.DOLLY,RIGHT:Vi.PAN},e.touches={ONE:ts.PAN,TWO:ts.DOLLY_PAN}),e.addEventListener("change",()=>{this.moves(),this.redraw(),this.following||this.onMove?.(this.standpoint())}),e}moves(){let{shadowed:e}=this;!this.software||this.following||!e||e.visibleFaces<=E2||(this.moving=!0,clearTimeout(this.standing),this.standing=window.setTimeout(()=>{this.moving=!1,this.redraw()},T2))}stand(){clearTimeout(this.standing),this.moving=!1}standpoint(){return{position:this.camera.position.clone(),target:this.controls.target.clone(),zoom:this.camera.zoom}}follow(e){this.following=!0,this.camera.position.copy(e.position),this.controls.target.copy(e.target),this.camera.zoom=e.zoom,this.camera.updateProjectionMatrix(),this.controls.update(),this.following=!1,this.redraw()}look(e,t="default"){e.isEmpty()||(this.box=e.clone());let n=this.box.getCenter(new N),s=this.box.getSize(new N);if(this.controls.target.copy(n),this.camera.zoom=1,this.camera instanceof Ri)this.camera.position.set(n.x,n.y,n.z+100),this.frameOrthographic(s);else{let r={default:[-.55,.62,1],x:[1,0,0],y:[0,1,.001],z:[0,0,1]},o={default:[-.55,-1,.62],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},a=this.up==="y"?r:o,l=Math.max(1e-9,.5*s.length()),c=Jn.degToRad(this.camera.fov/2),h=Math.min(c,Math.atan(Math.tan(c)*this.camera.aspect)),u=new N(...a[t]).normalize().multiplyScalar(1.02*l/Math.sin(h));this.camera.position.copy(n).add(u),this.camera.near=l/200,this.camera.far=l*200}this.camera.updateProjectionMatrix(),this.controls.update(),this.stand(),this.redraw()}frameOrthographic(e){let t=this.camera,{clientWidth:n,clientHeight:s}=this.host,r=n>0&&s>0?n/s:1,o=.53*Math.max(e.y,e.x/r,1e-9);t.left=-o*r,t.right=o*r,t.top=o,t.bottom=-o}resize(){let{clientWidth:e,clientHeight:t}=this.host;e===0||t===0||(this.renderer.setSize(e,t,!1),this.camera instanceof pn?this.camera.aspect=e/t:this.frameOrthographic(this.box.getSize(new N)),this.camera.updateProjectionMatrix(),this.draw())}redraw(){this.due||(this.due=!0,requestAnimationFrame(()=>{this.due&&this.draw()}))}draw(){this.due=!1;let e=this.up==="y"?new N(-1,1.5,.5):new N(-1,-.5,1.5);this.light.position.copy(e),this.sky.position.set(0,this.up==="y"?1:0,this.up==="y"?0:1),this.onDraw?.(this.metresPerPixel(),this.moving);let{shadowed:t,camera:n}=this;t?.isSolid&&!this.moving&&!this.tooMany(t)&&n instanceof pn?this.shading.draw(t.solid,n,t.sphere,e,t.size):this.shading.clear(),this.renderer.render(this.scene,this.camera),this.onDrawn?.()}tooMany(e){return e.visibleFaces>S2[this.software?1:0]}ray(e,t){let n=this.canvas.getBoundingClientRect(),s=new we(2*(e-n.left)/n.width-1,1-2*(t-n.top)/n.height),r=new gl;return r.setFromCamera(s,this.camera),r}onScreen(e){let t=this.canvas.getBoundingClientRect(),n=e.clone().project(this.camera);return[t.left+(.5+.5*n.x)*t.width,t.top+(.5-.5*n.y)*t.height]}triad(){let e=this.camera.quaternion.clone().invert();return[0,1,2].map(t=>{let n=new N().setComponent(t,1).applyQuaternion(e);return[n.x,n.y]})}metresPerPixel(){let e=Math.max(1,this.host.clientHeight);return this.camera instanceof Ri?(this.camera.top-this.camera.bottom)/this.camera.zoom/e:2*this.camera.position.distanceTo(this.controls.target)*Math.tan(Jn.degToRad(this.camera.fov/2))/e}};function A2(){let i=document.createElement("canvas").getContext("webgl2");if(!i)return!1;let e=i.getExtension("WEBGL_debug_renderer_info"),t=String(i.getParameter(e?e.UNMASKED_RENDERER_WEBGL:i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(t)}var R2=.5,ku=class{object=new jt;whole=new Bu;fine=new Bu;constructor(){this.object.add(this.whole.object,this.fine.object)}draw(e,t,n,s,r){if(this.whole.clear(),this.fine.clear(),!e)return null;let{longest:o,tetSize:a}=e.info,l=0;if(o!==null){let c=.9*t.size*s.vectorSize,h={longest:o,arms:e.f32("arms"),tension:e.u8("tension")};if(l=this.whole.draw(h,...C2(t,n,s,new Set(e.u32("tetBlock"))),c,Math.min(c/14,r)),a!==null){let u={longest:o,arms:e.f32("tetArms"),tension:e.u8("tetTension")},f=R2*a*s.vectorSize;l+=this.fine.draw(u,...P2(t,n,s,e),f,Math.min(f/10,r))}}return{...e.info,beyond:l}}},Bu=class extends ta{draw({longest:e,arms:t,tension:n},s,r,o,a){this.clear();let l=Math.max(1,Math.ceil(s.length/wp)),c=s.filter((m,g)=>g%l===0),h=new Xs(new xr(1,1,1),this.material,3*c.length),u=new tn,f=new N,d=new qe,p=0;for(let m of c)for(let g=0;g<3;g++){let b=f.fromArray(t,9*m+3*g).length();b>.01*e&&(u.position.fromArray(r,3*m),u.quaternion.setFromUnitVectors(na,f.divideScalar(b)),u.scale.set(o*Math.min(1,b/e),a,a),u.updateMatrix(),h.setMatrixAt(p,u.matrix),h.setColorAt(p++,d.set(n[3*m+g]?Dl:Ll)))}h.count=p,h.frustumCulled=!1,h.renderOrder=4,this.mesh=h,this.object.add(h);let x=m=>[0,1,2].some(g=>f.fromArray(t,9*m+3*g).length()>1.001*e);return s.filter(x).length}};function C2(i,e,t,n){let s=i.dimension===2,r=new Float32Array(3*i.count),o=[],a=new N;for(let l=0;l<i.count;l++){e(l,a).multiplyScalar(t.exaggeration);for(let h=0;h<3;h++)r[3*l+h]=i.middles[3*l+h]+a.getComponent(h);let c=s||i.cutBlocks===0?!i.isAway(a.fromArray(r,3*l)):i.isCut(l);s&&(r[3*l+2]=.5),i.isShown(l)&&c&&Number.isFinite(a.x)&&!n.has(l)&&o.push(l)}return[o,r]}function P2(i,e,t,n){let[s,r]=[n.f32("tetCorners"),n.u32("tetBlock")],o=new Float32Array(3*r.length),a=[],[l,c,h]=[new N,new N,new N];return r.forEach((u,f)=>{if(u>=i.count||!i.isShown(u))return;e(u,h).multiplyScalar(t.exaggeration-1),c.set(0,0,0);let[d,p]=[0,0];for(;p<4;p++)l.fromArray(s,12*f+3*p).add(h),i.isAway(l)&&d++,c.addScaledVector(l,.25);c.toArray(o,3*f),(i.cutBlocks===0?d===0:d>0&&d<p)&&Number.isFinite(c.x)&&a.push(f)}),[a,o]}function zu(i,e){let t=new Set,n=(s,r)=>{for(let o=s;o<=r;o++)t.add(o)};for(let[,s]of i.matchAll(/`([^`]+)`/g)){let[,r,o]=/^(.*)\.(\d+)$/.exec(s)??[];for(let a of e.blocks){let l=a.count??1;if(a.name===s)n(a.first,a.first+l-1);else if(a.from!==void 0&&a.name===r){let c=Number(o)-a.from;c>=0&&c<l&&n(a.first+c,a.first+c)}}for(let a of e.groups)if(a.name===s)for(let[l,c]of a.blocks)n(l,c)}return[...t].sort((s,r)=>s-r)}var Hu="#e8a200",I2=2e3,L2=5e4,D2=9,Vu=class{constructor(e,t,n){this.run=e;this.host=t;this.loading=n;this.stage=new Ou(t,2),this.stage.onDraw=(s,r)=>this.blocks?.fade(s,r),this.arrows={plane:new wr(!0),space:new wr(!1)},this.marks={plane:new ea(!0),space:new ea(!1)},this.warnedDots.frustumCulled=!1,this.warnedDots.renderOrder=4,this.stage.scene.add(this.warnedDots);for(let s of[...Object.values(this.arrows),...Object.values(this.marks),this.pickedMark,this.supportMark,this.drivenMark,this.warnedMark,this.bolts,this.chains,this.charges,this.stress,this.conditions,this.joints,this.ruler])this.stage.scene.add(s.object)}run;host;loading;stage;scale=new du;blocks=null;frame=-1;motion=null;unit="";arrow=null;between=null;trouble=null;picked=null;values=null;arrows;marks;pickedMark=new Zr;supportMark=new Zr("#2f7bd9",3);drivenMark=new Zr("#e07b1a",3);warnedMark=new Zr(Hu,4);warnedDots=new $s(new vt,new ys({color:Hu,size:10,sizeAttenuation:!1,depthTest:!1,transparent:!0}));bolts=new bu;chains=new vu;charges=new yu;stress=new ku;conditions=new Cu;joints=new Ru;ruler=new gu;ends=[];conditionNotes=[];warned=0;supports=null;driven=0;boltForces=null;chained=null;stressShown=null;last=null;ticket=0;ink="#000000";hasty=!1;others=[];get flat(){return this.blocks?.dimension!==3}get unshaded(){let{blocks:e,stage:t}=this;if(!e||e.dimension===2)return"";if(!e.isSolid)return"No shadows between blocks of glass.";let n=t.tooMany(e);return!n&&!e.crowded?"":`No ${[n?"shadows":"",e.crowded?"edges":""].filter(Boolean).join(" and ")}: ${e.visibleFaces.toLocaleString("en")} faces are too many ${t.software?"without graphics hardware":"for them"}.`}setTheme(e,t){this.stage.background=e;for(let n of Object.values(this.arrows))n.colour=t;this.ink=t,this.blocks?.tint(t),this.stage.redraw()}async show(e,t){let n=++this.ticket;if(this.run.frames===0)return!0;try{let s=await this.fetch(e,t);if(n!==this.ticket)return!1;let r=s.motion.info.shape;if(this.blocks?.shape.info.key!==r){let o=await this.run.shape(r,e);if(n!==this.ticket)return!1;let a=o.u32("ids").length,l=a>L2?await this.loading.announce(`Preparing ${a.toLocaleString("en")} blocks`):null;if(n===this.ticket&&this.build(new Au(o,this.scale,this.stage.shading.lit,this.stage.software)),l&&this.loading.end(l),n!==this.ticket)return!1;let{conditions:c,blocks:h}={conditions:this.run.conditions,blocks:this.blocks};if(c&&h.ids.some(u=>u>=c.blocks)&&await this.run.readModel(),n!==this.ticket)return!1}this.last=s,this.trouble=null,this.apply(t,!0)}catch(s){if(n!==this.ticket)return!1;this.trouble=Sr(s)}return this.frame=e,!0}prefetch(e,t){return this.fetch(e,t).catch(()=>{})}async fetch(e,t){let{field:n,vectors:s,rangeMode:r}=t,{held:o}=this.run.summary,a=s==="contact force"||s==="seepage flow",l=(t.contacts||t.cracks||t.chains||a)&&(!o||o.contacts),c=s!==""&&!a&&this.run.hasField(s)&&(!o||o.vectors.includes(s)),h=Promise.resolve(null),u=n!==""&&this.run.hasField(n),f=t.cracks&&this.run.summary.cracks,d=t.bolts&&this.run.summary.bolts===!0,p=t.stress&&this.run.hasStress,x=t.supports&&this.run.hasField("held"),m=t.joints==="interface"&&this.run.hasField("material"),[g,b,M,y,R,S,v,w,C,P]=await Promise.all([this.run.motion(e),u?this.run.field(e,n):h,u&&!this.hasty&&(r==="run"||r==="most")&&!Mr.has(n)?this.sharedRange(n,r):h,c?this.run.vectors(e,s):h,l?this.run.contacts(e):h,f?this.run.cracks(e).catch(()=>null):h,d?this.run.bolts(e).catch(()=>null):h,p?this.run.stress(e):h,x?this.run.field(e,"held").catch(()=>null):h,m?this.run.field(e,"material").catch(()=>null):h]);return{k:e,motion:g,field:b,range:M,vectors:y,contacts:R,cracks:S,bolts:v,stress:w,supports:C,materials:P}}async sharedRange(e,t){return(await Promise.all([this.run,...this.others].map(s=>s.range(e)))).map(s=>t==="most"?s.most:s.range).reduce(Nu,null)}build(e){let t=this.blocks===null,n=this.blocks;n&&(this.stage.scene.remove(n.object),n.dispose()),this.blocks=e,e.tint(this.ink);let s=this.run.summary.manifest.gravity??[0,0,0],r=e.dimension===3&&Math.abs(s[1])>Math.max(Math.abs(s[0]),Math.abs(s[2]))?"y":"z";this.stage.setDimension(e.dimension,r),this.stage.scene.add(e.object),t&&(this.charges.build(this.run.summary.manifest.sources??[],e.shape.info.origin,.3*e.size),this.stage.look(e.box()))}apply(e,t){let{last:n,blocks:s}=this;if(!n||!s)return;let r=this.look(e);this.motion=n.motion,t&&s.move(n.motion,r),this.values=n.field?.f32("values")??null,this.unit=n.field?.info.unit??"",this.tune(e),s.paint(this.values,this.scale),s.reveal(r,this.values),s.glass=(e.cracks||e.chains||e.joints!=="")&&!this.flat,this.stage.shadowed=e.shadows?s:null,this.stage.shading.moved();let{planes:o}=s;for(let l of Object.values(this.marks))l.end(o);this.charges.object.visible=e.charges,this.drawArrows(e),this.drawContacts(e),this.drawBolts(e),this.drawChains(e);let a=e.stress?n.stress:null;this.stressShown=this.stress.draw(a,s,(l,c)=>this.shiftOf(l,1,c),e,this.modelSize()/250),this.drawPicked(),this.drawWarned(),this.drawSupports(e),this.drawConditions(e),this.stage.redraw()}drawBolts(e){let t=e.bolts?this.last.bolts:null;if(this.boltForces=t?.info??null,!t){this.bolts.clear();return}let n=(s,r)=>this.shiftOf(s,e.exaggeration-1,r);this.bolts.draw(t,this.blocks,n,this.modelSize()/250)}drawChains(e){let t=e.chains?this.last.contacts:null;this.chained=null,this.chains.clear();let n=t?.info.longest??0;if(!t?.has("forces")||!(n>0))return;let s=this.blocks,r=this.contactPlaces(e),o=new N;for(let h=0;h<r.length;h+=3)s.isAway(o.fromArray(r,h))&&(r[h]=NaN);let a=h=>h>=s.count||!s.isShown(h)?null:this.shiftOf(h,e.exaggeration,new N).add(new N().fromArray(s.middles,3*h)),l=.015*this.modelSize()*e.vectorSize,c=this.chains.draw(t,r,a,l);this.chained={count:c,longest:n,unit:t.info.forceUnit??""}}drawSupports(e){let t=e.supports?this.last.supports?.f32("values"):void 0;if(this.supports=null,!t){this.supportMark.draw(null),this.drivenMark.draw(null);return}let n=[[],[]];this.supports=0,this.driven=0;let s=new Map((this.run.conditions?.supports??[]).flatMap(r=>r.blocks.map(o=>[o,r.driven])));t.forEach((r,o)=>{if(!(r>0))return;this.supports++;let a=s.get(this.blocks.ids[o])===!0;if(a&&this.driven++,this.blocks.isShown(o))for(let l of this.blocks.outline(o))n[a?1:0].push(l)}),this.supportMark.draw(new Float32Array(n[0])),this.drivenMark.draw(new Float32Array(n[1]))}drawConditions(e){let{conditions:t}=this.run,n=this.blocks,s=(o,a)=>this.shiftOf(o,e.exaggeration,a),r=o=>o?t:null;this.conditionNotes=[...this.conditions.drawFaces(r(e.boundaries),n),...this.conditions.drawLoads(r(e.loads),n,s,.1*this.modelSize()),...this.conditions.drawWater(r(e.water),n,this.last.motion.info.phase),...this.joints.draw(e.joints,n,t,this.last.materials?.f32("values")??null)]}look(e){return{exaggeration:e.exaggeration,edges:e.edges,clip:this.cut(e),only:e.only?[this.scale.low,this.scale.high]:null}}cut(e){let{clipAxis:t,clipAt:n,clipDip:s,clipDirection:r,clipFlip:o,clipFlat:a}=e;if(t===""||t==="z"&&this.flat)return null;let l=[0,0,0];t!=="free"?l["xyz".indexOf(t)]=1:l=this.flat?xb(s):gb(s,r);let{low:c,high:h}=this.blocks.shape.info,u=[0,0];l.forEach((x,m)=>{u[0]+=Math.min(x*c[m],x*h[m]),u[1]+=Math.max(x*c[m],x*h[m])});let f=u[0]+n*(u[1]-u[0]),d=a?this.blocks.clearOf(l,f):f;return{normal:l,at:d,keep:(t==="z"||t==="free")===o?1:-1,flat:a}}cutAway(e){let t=this.blocks&&this.cut(e);if(!t)return null;let n=-t.keep;return{normal:t.normal.map(s=>n*s),at:n*this.placeAlong(t)}}placeAlong({normal:e,at:t}){let{origin:n}=this.blocks.shape.info;return t+e.reduce((s,r,o)=>s+r*n[o],0)}cutText(e){let t=this.blocks&&this.cut(e);if(!t)return"";let{clipAxis:n,clipDip:s,clipDirection:r}=e;if(n!=="free")return`cut at ${n} = ${un(this.placeAlong(t),"m",3)}`;let o=a=>String(Math.round(a)).padStart(this.flat?1:2,"0");return this.flat?`cut at ${o(s)}\xB0 from x`:`cut ${o(s)}\xB0/${o(r).padStart(3,"0")}\xB0 (dip/direction)`}tune(e){let{scale:t,last:n}=this;if(t.kinds=Mr.has(e.field),t.field=e.field,!this.values){t.kinds=!1,t.plain();return}let s=n?.field?.info,r=e.rangeMode==="most"?s?.most??s?.range:s?.range,[o,a]=(e.rangeMode==="frame"?r:n?.range??r)??[0,1];e.rangeMode==="fixed"?[o,a]=[e.low,e.high]:e.map==="blue-red"&&o<0&&a>0&&!e.log&&(a=Math.max(-o,a),o=-a),e.log&&(a=a>0?a:1,o=o>0?o:a*1e-6,o=Math.max(o,a*1e-9)),a>o||(a=o+(Math.abs(o)||1)*1e-6),t.low=o,t.high=a,t.log=e.log,t.paint(e.map)}get survey(){let{blocks:e}=this;return!e||this.flat?[]:Array.from({length:e.count},(t,n)=>n).filter(t=>e.isSurvey(t))}shiftOf(e,t,n){let s=this.last.motion.f32("shifts");return this.flat?n.set(s[2*e],s[2*e+1],0):n.fromArray(s,3*e),n.multiplyScalar(t)}drawArrows(e){let{last:t,blocks:n}=this;this.arrow=null;let s=this.flat?this.arrows.plane:this.arrows.space,r=new N,o=.08*this.modelSize()*e.vectorSize,a=e.vectors==="seepage flow",l=a?"flows":"forces";if((a||e.vectors==="contact force")&&t.contacts?.has(l)){let c=t.contacts,h=(a?c.info.fastest:c.info.longest)??0,u=this.contactPlaces(e);for(let f=0;f<u.length;f+=3)n.isAway(r.fromArray(u,f))&&(u[f]=NaN);h>0?s.draw(u,c.f32(l),h,o):s.clear(),this.arrow={longest:h,unit:(a?c.info.flowUnit:c.info.forceUnit)??""}}else if(t.vectors){let c=new Float32Array(3*n.count),h=t.vectors.f32("values");for(let f=0;f<n.count;f++){this.shiftOf(f,e.exaggeration,r);for(let p=0;p<3;p++)c[3*f+p]=n.middles[3*f+p]+r.getComponent(p);(!n.isShown(f)||n.isAway(r.fromArray(c,3*f)))&&(c[3*f]=NaN)}let u=t.vectors.info.longest??0;u>0?s.draw(c,h,u,o):s.clear(),this.arrow={longest:u,unit:t.vectors.info.unit}}else s.clear()}modelSize(){let{low:e,high:t}=this.blocks.shape.info;return Math.hypot(t[0]-e[0],t[1]-e[1],t[2]-e[2])||1}contactPlaces(e){return fb(this.last.contacts,this.blocks,(t,n)=>this.shiftOf(t,e.exaggeration-1,n))}drawContacts(e){let t=this.last.contacts,n=this.flat?this.marks.plane:this.marks.space;if(this.between=t?{counts:ea.count(t),areas:t.info.areas,unit:t.info.areaUnit}:null,t&&e.contacts?n.drawPoints(t,this.contactPlaces(e),e.states):n.hide("points"),t&&e.cracks&&!this.flat){let s=(r,o)=>this.shiftOf(r,e.exaggeration-1,o);n.drawCracks(t,this.last.cracks,this.blocks,s)}else n.hide("cracks")}drawPicked(){let e=this.picked===null?-1:this.blocks.placeOf(this.picked);this.pickedMark.draw(e<0?null:this.blocks.outline(e))}drawWarned(){let e=this.blocks,{preview:t,warnings:n}=this.run.summary.manifest,s=t?new Set(n.flatMap(c=>zu(c,this.run.names))):new Set;this.warned=s.size;let o=[...s].map(c=>e.placeOf(c)).filter(c=>c>=0&&e.isShown(c)).slice(0,I2),a=o.flatMap(c=>[...e.outline(c)]);this.warnedMark.draw(a.length>0?new Float32Array(a):null);let l=o.flatMap(c=>[...e.middles.subarray(3*c,3*c+2),this.flat?.6:e.middles[3*c+2]]);this.warnedDots.geometry.dispose(),this.warnedDots.geometry.setAttribute("position",new rt(l,3)),this.warnedDots.visible=l.length>0}goTo(e){let{blocks:t}=this;if(!t)return;let n=new wn;for(let s of e.map(r=>t.placeOf(r)))if(s>=0)for(let r of t.cornersOf(s))n.expandByPoint(r);n.isEmpty()||this.stage.look(n.expandByScalar(n.getSize(new N).length()))}pickAt(e,t){if(!this.blocks)return null;let n=this.blocks.pick(this.stage.ray(e,t));return n===null?null:this.blocks.ids[n]}placeAt(e,t){if(!this.blocks)return null;let n=this.stage.ray(e,t),s=this.blocks.hit(n),r=a=>{let[l,c]=this.stage.onScreen(a);return Math.hypot(l-e,c-t)},o=s?this.blocks.cornersOf(s.block).reduce((a,l)=>r(l)<r(a)?l:a):null;if(o&&r(o)<D2&&!this.blocks.isAway(o))return o;if(this.flat){let{origin:a,direction:l}=n.ray;return a.clone().addScaledVector(l,-a.z/l.z)}return s?.point??null}lay(e){this.ends=e,this.ruler.draw(e,this.flat),this.stage.redraw()}lineText(){let[e,t]=this.ends;if(!e)return"";if(!t)return"line: click its other end";let n=t.clone().sub(e),s=o=>kt(Math.abs(o)<1e-6*n.length()?0:o,4),r=(this.flat?[n.x,n.y]:n.toArray()).map(s).join(", ");return`distance ${un(n.length(),"m",5)} (${r})`}along(){let[e,t]=this.ends;return!e||!t||!this.blocks?{pieces:[],length:0}:{pieces:hb(this.blocks,e,t).filter(n=>this.blocks.isShown(n.block)),length:e.distanceTo(t)}}pick(e){this.picked=e,this.blocks&&this.drawPicked(),this.stage.redraw()}niceExaggeration(){let e=this.last?.motion.f32("shifts");if(!e)return 1;let t=this.flat?2:3,n=0;for(let o=0;o<e.length;o+=t)n=Math.max(n,Math.hypot(e[o],e[o+1],t===3?e[o+2]:0));if(!(n>0))return 1;let s=.05*this.modelSize()/n,r=10**Math.floor(Math.log10(s));return Math.max(1,r*Math.floor(s/r))}fit(e){this.blocks&&this.stage.look(this.blocks.box().union(this.conditions.reach),e)}};function Gu(i,e){let{scale:t}=i,n={title:"",marks:[],kinds:t.kinds,notes:[]},s=i.survey;if(i.values&&e.field)if(t.kinds){n.title=e.field;let c=[...new Set(i.values)].filter(Number.isFinite).sort((h,u)=>h-u);if(c.length<=10){let h=e.field==="material"?s.map(f=>i.values[f]):[],u=f=>h.includes(f)?pu:Yr(f,e.field);n.marks=c.map((f,d)=>({at:d,text:Fp(i.run,e.field,f),colour:u(f)}))}}else{let c=_p(Math.max(Math.abs(t.low),Math.abs(t.high)),i.unit);n.title=e.field+(c.unit?` [${c.unit}]`:""),n.marks=N2(t,c.factor);let h=i.values.filter(u=>t.isBeyond(u)).length;h>0&&n.notes.push({text:`${h} block${h===1?"":"s"} beyond`})}s.length>0&&!t.kinds&&n.notes.push({text:"ground, without the field",colour:pu}),i.warned>0&&n.notes.push({text:`${i.warned} block${i.warned===1?"":"s"} with warnings`,colour:Hu}),i.supports!==null&&n.notes.push({text:`${i.supports} held or moved`,colour:"#2f7bd9"}),i.supports!==null&&i.driven>0&&n.notes.push({text:`${i.driven} of them driven`,colour:"#e07b1a"}),n.notes.push(...i.conditionNotes);let r=(i.run.summary.manifest.sources??[]).map(c=>c.name);if(e.charges&&r.length>0&&n.notes.push({text:r.length===1?`charge ${r[0]}`:`${r.length} charges`,colour:Ep}),i.boltForces&&i.boltForces.largest!==null){let{largest:c,smallest:h,unit:u}=i.boltForces;n.notes.push({text:`bolts up to ${un(c,u,3)}`,colour:"#d01c1c"}),h!==null&&h<0&&n.notes.push({text:`bolts down to ${un(h,u,3)}`,colour:"#1d5fd0"})}if(i.chained){let{count:c,longest:h,unit:u}=i.chained;n.notes.push({text:`forces of ${c} contacts up to ${un(h,u,3)}`,colour:Sp})}if(i.stressShown?.range){let{range:[c,h],longest:u,unit:f,beyond:d}=i.stressShown;c<0&&n.notes.push({text:`compression up to ${un(-c,f,3)}`,colour:Ll}),h>0&&n.notes.push({text:`tension up to ${un(h,f,3)}`,colour:Dl}),u!==null&&n.notes.push({text:`longest cross ${un(u,f,3)}${d>0?`, ${d} beyond`:""}`})}i.arrow&&e.vectors&&n.notes.push({text:`longest ${e.vectors} ${un(i.arrow.longest,i.arrow.unit,3)}`}),e.exaggeration!==1&&n.notes.push({text:`displacements \xD7 ${kt(e.exaggeration)}`});let o=i.lineText();o&&n.notes.push({text:o,colour:Mp});let a=i.cutText(e);a&&n.notes.push({text:a});let{between:l}=i;return l&&(e.contacts||e.cracks)&&Qs.forEach((c,h)=>{let u=e.contacts&&e.states[h]||e.cracks&&!i.flat&&h>=_u,f=l.counts[h];if(!u||f===0&&h>1)return;let d=l.unit==="m2"?"m\xB2":l.unit,p=h>=_u?` (${kt(l.areas[h],3)} ${d})`:"";n.notes.push({text:`${c.name} ${f}${p}`,colour:c.colour})}),n}function Fp(i,e,t){switch(e){case"block":return i.called(t);case"material":return i.summary.manifest.materials?.[t]??kt(t);case"held":return t>0?"held or driven":"free";case"surface":return t>0?"at the surface":"inside";case"removable_type":return["inside, or ground","key block","held by strength","held by weight","tapered"][t]??kt(t);case"removable_mode":return["not removable","stays","slides on one plane","slides on two planes","falls"][t]??kt(t);case"level":return t>0?`split ${kt(t)} times`:"not split";default:return kt(t)}}function N2(i,e){let{low:t,high:n}=i;if(i.log){let r=[],o=Math.ceil(Math.log10(t)-1e-9),a=Math.floor(Math.log10(n)+1e-9),l=Math.max(1,Math.ceil((a-o)/5));for(let c=o;c<=a;c+=l){let h=(c-Math.log10(t))/(Math.log10(n)-Math.log10(t));r.push({at:h,text:kt(10**c*e,3)})}return r}return cb(t*e,n*e,4).map(r=>({at:(r/e-t)/(n-t),text:kt(r,4)}))}function Bb(i,e){let t=Q("div.legend");if(i.title&&t.append(Q("div.title",{},i.title)),i.kinds)for(let n of i.marks){let s=Q("i.chip");s.style.background=n.colour??"",t.append(Q("div.note",{},s,n.text))}else if(i.marks.length>0){let n=Q("div.strip"),s=Array.from({length:17},(o,a)=>e.css(a/16));n.style.background=`linear-gradient(to top, ${s.join(",")})`;let r=Q("div.scale",{},n);for(let o of i.marks){let a=Q("span.tick",{},o.text);a.style.bottom=`${100*o.at}%`,r.append(a)}t.append(r)}for(let n of i.notes){let s=n.colour?Q("i.chip"):null;s&&(s.style.background=n.colour),t.append(Q("div.note",{},s,n.text))}return t}function zb(i,e,t,[n,s],r,o){i.textBaseline="middle",i.font=`600 ${12*r}px system-ui, sans-serif`,i.fillStyle=o;let a=s+10*r;e.title&&(i.fillText(e.title,n,a),a+=16*r),i.font=`${11*r}px system-ui, sans-serif`;let l=c=>{i.fillStyle=c,i.fillRect(n,a-5*r,10*r,10*r),i.fillStyle=o};if(e.kinds)for(let c of e.marks)l(c.colour??o),i.fillText(c.text,n+16*r,a),a+=15*r;else if(e.marks.length>0){let c=140*r,h=i.createLinearGradient(0,a+c,0,a);for(let u=0;u<=16;u++)h.addColorStop(u/16,t.css(u/16));i.fillStyle=h,i.fillRect(n,a,14*r,c),i.fillStyle=o;for(let u of e.marks)i.fillText(u.text,n+20*r,a+c*(1-u.at));a+=c+14*r}for(let c of e.notes)c.colour&&l(c.colour),i.fillText(c.text,c.colour?n+16*r:n,a),a+=15*r}var Mt={EBML:440786851,EBMLVersion:17030,EBMLReadVersion:17143,EBMLMaxIDLength:17138,EBMLMaxSizeLength:17139,DocType:17026,DocTypeVersion:17031,DocTypeReadVersion:17029,Segment:408125543,Info:357149030,TimestampScale:2807729,Duration:17545,MuxingApp:19840,WritingApp:22337,Tracks:374648427,TrackEntry:174,TrackNumber:215,TrackUID:29637,TrackType:131,FlagLacing:156,CodecID:134,DefaultDuration:2352003,Video:224,PixelWidth:176,PixelHeight:186,Cues:475249515,CuePoint:187,CueTime:179,CueTrackPositions:183,CueTrack:247,CueClusterPosition:241,Cluster:524531317,Timestamp:231,SimpleBlock:163},U2=3e4;function Op(i){let e=new Uint8Array(i.reduce((n,s)=>n+s.length,0)),t=0;for(let n of i)e.set(n,t),t+=n.length;return e}function kp(i,e=1){let t=[];for(let n=i;n>0||t.length<e;n=Math.floor(n/256))t.unshift(n%256);return Uint8Array.from(t)}function xi(i,...e){let t=kp(e.reduce((n,s)=>n+s.length,0),8);return t[0]=1,Op([kp(i),t,...e])}function Bn(i,e,t=1){return xi(i,kp(e,t))}function Wu(i,e){return xi(i,new TextEncoder().encode(e))}function F2(i,e){let t=new Uint8Array(8);return new DataView(t.buffer).setFloat64(0,e),xi(i,t)}function O2(i){let e=n=>Math.round(1e3*n/i.framesPerSecond),t=[];return i.frames.forEach((n,s)=>{let r=t.at(-1);(r===void 0||n.key||e(s)-e(r)>U2)&&t.push(s)}),t.map((n,s)=>{let r=e(n),o=i.frames.slice(n,t[s+1]).map((a,l)=>{let c=e(n+l)-r,h=Uint8Array.from([129,c>>8,c&255,a.key?128:0]);return xi(Mt.SimpleBlock,h,a.data)});return{start:r,bytes:xi(Mt.Cluster,Bn(Mt.Timestamp,r),...o)}})}function Hb(i){let{width:e,height:t,codec:n,framesPerSecond:s,frames:r}=i,o=xi(Mt.EBML,Bn(Mt.EBMLVersion,1),Bn(Mt.EBMLReadVersion,1),Bn(Mt.EBMLMaxIDLength,4),Bn(Mt.EBMLMaxSizeLength,8),Wu(Mt.DocType,"webm"),Bn(Mt.DocTypeVersion,4),Bn(Mt.DocTypeReadVersion,2)),a=xi(Mt.Info,Bn(Mt.TimestampScale,1e6),F2(Mt.Duration,1e3*r.length/s),Wu(Mt.MuxingApp,"riprap"),Wu(Mt.WritingApp,"riprap")),l=xi(Mt.TrackEntry,Bn(Mt.TrackNumber,1),Bn(Mt.TrackUID,1),Bn(Mt.TrackType,1),Bn(Mt.FlagLacing,0),Wu(Mt.CodecID,n),Bn(Mt.DefaultDuration,Math.round(1e9/s)),xi(Mt.Video,Bn(Mt.PixelWidth,e),Bn(Mt.PixelHeight,t))),c=Op([a,xi(Mt.Tracks,l)]),h=O2(i),u=p=>xi(Mt.Cues,...h.map(({start:x},m)=>xi(Mt.CuePoint,Bn(Mt.CueTime,x),xi(Mt.CueTrackPositions,Bn(Mt.CueTrack,1),Bn(Mt.CueClusterPosition,p[m],8))))),f=c.length+u(h.map(()=>0)).length,d=h.map(({bytes:p})=>(f+=p.length)-p.length);return Op([o,xi(Mt.Segment,c,u(d),...h.map(p=>p.bytes))])}var Vb=2e3;function Bp(i,e,t=document.createElement("canvas")){let n=i[0].stage.renderer.getPixelRatio(),s=getComputedStyle(document.documentElement),r=s.getPropertyValue("--ink").trim(),o=s.getPropertyValue("--paper").trim(),a=Math.round(26*n);for(let{stage:d}of i)d.stand(),d.draw();let l=i.map(d=>[d.stage.canvas.width,d.stage.canvas.height]),c=l.reduce((d,p)=>d+p[0],0)&-2,h=Math.max(...l.map(d=>d[1]))+a&-2;(t.width!==c||t.height!==h)&&(t.width=c,t.height=h);let u=t.getContext("2d");u.fillStyle=o,u.fillRect(0,0,c,h);let f=0;return i.forEach((d,p)=>{u.drawImage(d.stage.canvas,f,a);let{manifest:x}=d.run.summary,m=d.run.saidAt(d.frame);u.fillStyle=r,u.textBaseline="middle",u.font=`600 ${13*n}px system-ui, sans-serif`,u.fillText(`${x.title||d.run.summary.name}   ${m}`,f+12*n,a/2,l[p][0]-24*n),zb(u,Gu(d,e),d.scale,[f+14*n,a+8*n],n,r),f+=l[p][0]}),t}function Gb(i){return new Promise((e,t)=>{i.toBlob(n=>n?e(n):t(new Error("the browser made no picture")),"image/png")})}function zp(i){return i.map(e=>e.run.summary.name.replace(/\.run$/,"")).join("_")}async function Hp(i,e){let t=await Gb(Bp(i,e));lr(t,`${zp(i)}_${String(i[0].frame+1).padStart(6,"0")}.png`)}var k2=120;async function Wb([i,e,t,n],s,r){t.pause();let o=t.at,a=i[0].stage.standpoint(),l=f=>i.forEach(d=>d.stage.follow(f)),c=document.createElement("canvas"),h=t.moments.length,u=n&&h===1?k2:h;try{for(let f=0;f<u;f++){if(!s(f/u))return!1;f<h&&await t.go(f),n&&l(n(f/Math.max(1,u-1))),await r(Bp(i,e,c),f,u)}}finally{n&&l(a),await t.go(o)}return!0}async function B2(i,e){let t={};await Wb(i,e,async(s,r,o)=>{if(o>Vb)throw new Error(`${o} frames are too many for one zip, which has at most ${Vb}: riprap shot RUN --all -o FILE.png writes them to a folder.`);let a=await Gb(s);t[`frame_${String(r+1).padStart(6,"0")}.png`]=[new Uint8Array(await a.arrayBuffer()),{level:0}]})&&lr(new Blob([og(t)],{type:"application/zip"}),`${zp(i[0])}_frames.zip`)}var z2=[["vp09.00.51.08","V_VP9"],["vp8","V_VP8"]],H2=50,V2=4;async function G2(i,e,t){if(typeof VideoEncoder>"u"){let s=window.isSecureContext?"This browser has no video encoder (WebCodecs).":"Browsers encode video only on pages of this machine (127.0.0.1) or served by https.";throw new Error(`${s} Save all frames as PNG instead, or write the film without a browser: riprap shot RUN --all -o film.apng`)}let n=Math.max(2e6,Math.round(.35*i*e*t));for(let[s,r]of z2){let o={codec:s,width:i,height:e,framerate:t,bitrate:n,latencyMode:"quality"};if((await VideoEncoder.isConfigSupported(o)).supported)return[o,r]}throw new Error(`This browser cannot encode VP9 or VP8 at ${i} x ${e} pixels. Make the window smaller, or save all frames as PNG instead.`)}async function W2(i,e){let t=i[1].speed,n=[],s={},r=()=>{if(s.failed)throw new Error(`The browser could not encode the film: ${s.failed.message}`)},o=async({width:l,height:c})=>{let[h,u]=await G2(l,c,t);s.film={width:l,height:c,codec:u,framesPerSecond:t,frames:n};let f=new VideoEncoder({output:d=>{let p=new Uint8Array(d.byteLength);d.copyTo(p),n.push({data:p,key:d.type==="key"})},error:d=>s.failed=d});return f.configure(h),s.encoder=f},a=0;try{let l=await Wb(i,e,async(c,h,u)=>{a=u;let f=s.encoder??await o(c);if(c.width!==s.film.width||c.height!==s.film.height)throw new Error("The window changed its size while the film was made. Make it again and leave the window as it is.");let d=new VideoFrame(c,{timestamp:Math.round(1e6*h/t),duration:Math.round(1e6/t)});for(r(),f.encode(d,{keyFrame:h%H2===0}),d.close();f.encodeQueueSize>V2&&!s.failed;)await new Promise(p=>setTimeout(p,5))});if(r(),!l||!s.film)return;if(await s.encoder.flush(),r(),n.length!==a)throw new Error(`The browser encoded ${n.length} of ${a} frames. Save all frames as PNG instead.`);lr(new Blob([Hb(s.film)],{type:"video/webm"}),`${zp(i[0])}.webm`)}finally{s.encoder&&s.encoder.state!=="closed"&&s.encoder.close()}}function Xb(i,e){let t=new Map(i.flatMap(n=>n.keys.map(s=>[s,n])));document.addEventListener("keydown",n=>{if(document.querySelector("dialog[open]"))return;let s=e.matches(":hover")||e.contains(document.activeElement);if(e.classList.contains("replay")&&!s||n.ctrlKey||n.metaKey||n.altKey)return;let r=n.target;if(r instanceof HTMLSelectElement||r instanceof HTMLInputElement&&["number","text"].includes(r.type)||r instanceof HTMLInputElement&&r.type==="range"&&n.key.startsWith("Arrow")||r instanceof HTMLButtonElement&&(n.key===" "||n.key==="Enter"))return;let l=t.get(n.key.length===1?n.key.toLowerCase():n.key);l&&(n.preventDefault(),l.act(n.shiftKey))})}function qb(i){let e=Q("dialog.sheet",{"aria-label":"keyboard shortcuts"}),t=i.map(s=>Q("tr",{},Q("td",{},Q("kbd",{},s.label)),Q("td",{},s.what))),n=[["drag","rotate (in the plane: move)"],["right drag","move"],["wheel, pinch","zoom"],["click","pick a block; after d an end of the line"],["click in a plot","go to that time"]];return e.append(Q("h2",{},"Keys and mouse"),Q("div.columns",{},Q("table",{},...t),Q("table",{},...n.map(([s,r])=>Q("tr",{},Q("td",{},Q("kbd",{},s)),Q("td",{},r))))),Q("button",{type:"button",onclick:()=>e.close()},"Close")),e.addEventListener("click",s=>{s.target===e&&e.close()}),e}var X2="uplot",q2="u-hz",$2="u-vt",Y2="u-title",Z2="u-wrap",j2="u-under",J2="u-over",K2="u-axis",Kr="u-off",Q2="u-select",e3="u-cursor-x",t3="u-cursor-y",n3="u-cursor-pt",i3="u-legend",s3="u-live",r3="u-inline",o3="u-series",a3="u-marker",$b="u-label",l3="u-value",Fl="width",Ol="height";var Yb="bottom",ia="left",Gp="right",om="#000",Zb=om+"0",Wp="mousemove",jb="mousedown",Xp="mouseup",Jb="mouseenter",Kb="mouseleave",Qb="dblclick",c3="resize",h3="scroll",ev="change",Zu="dppxchange",am="--",ha=typeof window<"u",jp=ha?document:null,ra=ha?window:null,u3=ha?navigator:null,Ct,Xu;function Jp(){let i=devicePixelRatio;Ct!=i&&(Ct=i,Xu&&Qp(ev,Xu,Jp),Xu=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),Qr(ev,Xu,Jp),ra.dispatchEvent(new CustomEvent(Zu)))}function Pi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Kp(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Jt(i,e,t){i.style[e]=t+"px"}function ss(i,e,t,n){let s=jp.createElement(i);return e!=null&&Pi(s,e),t?.insertBefore(s,n),s}function Wi(i,e){return ss("div",i,e)}var tv=new WeakMap;function Ts(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=tv.get(i);r!=o&&(i.style.transform=r,tv.set(i,r),e<0||t<0||e>n||t>s?Pi(i,Kr):Kp(i,Kr))}var nv=new WeakMap;function iv(i,e,t){let n=e+t,s=nv.get(i);n!=s&&(nv.set(i,n),i.style.background=e,i.style.borderColor=t)}var sv=new WeakMap;function rv(i,e,t,n){let s=e+""+t,r=sv.get(i);s!=r&&(sv.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var lm={passive:!0},f3={...lm,capture:!0};function Qr(i,e,t,n){e.addEventListener(i,t,n?f3:lm)}function Qp(i,e,t,n){e.removeEventListener(i,t,lm)}ha&&Jp();function rs(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Ii((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Dv(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Nv=i=>i!=null,Uv=i=>i!=null&&i>0,Ku=Dv(Nv),d3=Dv(Uv);function p3(i,e,t,n=0,s=!1){let r=s?d3:Ku,o=s?Uv:Nv;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ht,l??-Ht]}function Qu(i,e,t,n){let s=lv(i),r=lv(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?er:Fv,a=s==1?Ii:Xi,l=r==1?Xi:Ii,c=a(o(In(i))),h=l(o(In(e))),u=oa(t,c),f=oa(t,h);return t==10&&(c<0&&(u=Vt(u,-c)),h<0&&(f=Vt(f,-h))),n||t==2?(i=u*s,e=f*r):(i=zv(i,u),e=ef(e,f)),[i,e]}function cm(i,e,t,n){let s=Qu(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var hm=.1,ov={mode:3,pad:hm},Bl={pad:0,soft:null,mode:0},m3={min:Bl,max:Bl};function ju(i,e,t,n){return tf(t)?av(i,e,t):(Bl.pad=t,Bl.soft=n?0:null,Bl.mode=n?3:0,av(i,e,m3))}function Et(i,e){return i??e}function g3(i,e,t){for(e=Et(e,0),t=Et(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function av(i,e,t){let n=t.min,s=t.max,r=Et(n.pad,0),o=Et(s.pad,0),a=Et(n.hard,-Ht),l=Et(s.hard,Ht),c=Et(n.soft,Ht),h=Et(s.soft,-Ht),u=Et(n.mode,0),f=Et(s.mode,0),d=e-i,p=er(d),x=ci(In(i),In(e)),m=er(x),g=In(m-p);(d<1e-24||g>10)&&(d=0,(i==0||e==0)&&(d=1e-24,u==2&&c!=Ht&&(r=0),f==2&&h!=-Ht&&(o=0)));let b=d||x||1e3,M=er(b),y=oa(10,Ii(M)),R=b*(d==0?i==0?.1:1:r),S=Vt(zv(i-R,y/10),24),v=i>=c&&(u==1||u==3&&S<=c||u==2&&S>=c)?c:Ht,w=ci(a,S<v&&i>=v?v:os(v,S)),C=b*(d==0?e==0?.1:1:o),P=Vt(ef(e+C,y/10),24),I=e<=h&&(f==1||f==3&&P>=h||f==2&&P<=h)?h:-Ht,O=os(l,P>I&&e<=I?I:ci(I,P));return w==O&&w==0&&(O=100),[w,O]}var x3=new Intl.NumberFormat(ha?u3.language:"en-US"),um=i=>x3.format(i),Li=Math,Yu=Li.PI,In=Li.abs,Ii=Li.floor,Pn=Li.round,Xi=Li.ceil,os=Li.min,ci=Li.max,oa=Li.pow,lv=Li.sign,er=Li.log10,Fv=Li.log2,b3=(i,e=1)=>Li.sinh(i)*e,qp=(i,e=1)=>Li.asinh(i/e),Ht=1/0;function cv(i){return(er((i^i>>31)-(i>>31))|0)+1}function em(i,e,t){return os(ci(i,e),t)}function Ov(i){return typeof i=="function"}function yt(i){return Ov(i)?i:()=>i}var v3=()=>{},kv=i=>i,Bv=(i,e)=>e,y3=i=>null,hv=i=>!0,uv=(i,e)=>i==e,_3=/\.\d*?(?=9{6,}|0{6,})/gm,eo=i=>{if(Vv(i)||Tr.has(i))return i;let e=`${i}`,t=e.match(_3);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${eo(s)}e${r}`}return Vt(i,n)};function jr(i,e){return eo(Vt(eo(i/e))*e)}function ef(i,e){return eo(Xi(eo(i/e))*e)}function zv(i,e){return eo(Ii(eo(i/e))*e)}function Vt(i,e=0){if(Vv(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Pn(n)/t}var Tr=new Map;function Hv(i){return((""+i).split(".")[1]||"").length}function Hl(i,e,t,n){let s=[],r=n.map(Hv);for(let o=e;o<t;o++){let a=In(o),l=Vt(oa(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Vt(h,u);s.push(f),Tr.set(f,u)}}return s}var zl={},fm=[],aa=[null,null],Er=Array.isArray,Vv=Number.isInteger,M3=i=>i===void 0;function fv(i){return typeof i=="string"}function tf(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function w3(i){return i!=null&&typeof i=="object"}var S3=Object.getPrototypeOf(Uint8Array),Gv="__proto__";function la(i,e=tf){let t;if(Er(i)){let n=i.find(s=>s!=null);if(Er(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=la(i[s],e)}else t=i.slice()}else if(i instanceof S3)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Gv&&(t[n]=la(i[n],e))}else t=i;return t}function Sn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Gv&&(tf(i[s])?Sn(i[s],la(n[s])):i[s]=la(n[s]))}return i}var E3=0,T3=1,A3=2;function R3(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function C3(i,e){if(L3(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return D3(o[0])||(o=I3(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=e?e[o][c]:T3,d=[];for(let p=0;p<h.length;p++){let x=h[p],m=r.get(l[p]);x===null?f!=E3&&(u[m]=x,f==A3&&d.push(m)):u[m]=x}R3(u,d,s),n.push(u)}}return n}var P3=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function I3(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function L3(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function D3(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ci(1,Ii((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Wv=["January","February","March","April","May","June","July","August","September","October","November","December"],Xv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function qv(i){return i.slice(0,3)}var N3=Xv.map(qv),U3=Wv.map(qv),F3={MMMM:Wv,MMM:U3,WWWW:Xv,WWW:N3};function Ul(i){return(i<10?"0":"")+i}function O3(i){return(i<10?"00":i<100?"0":"")+i}var k3={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Ul(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Ul(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Ul(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Ul(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Ul(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>O3(i.getMilliseconds())};function dm(i,e){e=e||F3;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?k3[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var B3=new Intl.DateTimeFormat().resolvedOptions().timeZone;function z3(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==B3?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var $v=i=>i%1==0,Ju=[1,2,2.5,5],H3=Hl(10,-32,0,Ju),Yv=Hl(10,0,32,Ju),V3=Yv.filter($v),Jr=H3.concat(Yv),pm=`
`,Zv="{YYYY}",dv=pm+Zv,jv="{M}/{D}",kl=pm+jv,qu=kl+"/{YY}",Jv="{aa}",G3="{h}:{mm}",sa=G3+Jv,pv=pm+sa,mv=":{ss}",It=null;function Kv(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Hl(10,0,3,Ju).filter($v):Hl(10,-3,0,Ju)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Zv,It,It,It,It,It,It,1],[s*28,"{MMM}",dv,It,It,It,It,It,1],[s,jv,dv,It,It,It,It,It,1],[n,"{h}"+Jv,qu,It,kl,It,It,It,1],[t,sa,qu,It,kl,It,It,It,1],[e,mv,qu+" "+sa,It,kl+" "+sa,It,pv,It,1],[i,mv+".{fff}",qu+" "+sa,It,kl+" "+sa,It,pv,It,1]];function h(u){return(f,d,p,x,m,g)=>{let b=[],M=m>=o,y=m>=r&&m<o,R=u(p),S=Vt(R*i,3),v=$p(R.getFullYear(),M?0:R.getMonth(),y||M?1:R.getDate()),w=Vt(v*i,3);if(y||M){let C=y?m/r:0,P=M?m/o:0,I=S==w?S:Vt($p(v.getFullYear()+P,v.getMonth()+C,1)*i,3),O=new Date(Pn(I/i)),z=O.getFullYear(),U=O.getMonth();for(let G=0;I<=x;G++){let q=$p(z+P*G,U+C*G,1),H=q-u(Vt(q*i,3));I=Vt((+q+H)*i,3),I<=x&&b.push(I)}}else{let C=m>=s?s:m,P=Ii(p)-Ii(S),I=w+P+ef(S-w,C);b.push(I);let O=u(I),z=O.getHours()+O.getMinutes()/t+O.getSeconds()/n,U=m/n,G=f.axes[d]._space,q=g/G;for(;I=Vt(I+m,i==1?0:3),!(I>x);)if(U>1){let H=Ii(Vt(z+U,6))%24,ee=u(I).getHours()-H;ee>1&&(ee=-1),I-=ee*n,z=(z+U)%24;let te=b[b.length-1];Vt((I-te)/m,3)*q>=.7&&b.push(I)}else b.push(I)}return b}}return[l,c,h]}var[W3,X3,q3]=Kv(1),[$3,Y3,Z3]=Kv(.001);Hl(2,-53,53,[1]);function gv(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function xv(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,h,u,f,d;return n.map(p=>{let x=i(p),m=x.getFullYear(),g=x.getMonth(),b=x.getDate(),M=x.getHours(),y=x.getMinutes(),R=x.getSeconds(),S=m!=l&&a[2]||g!=c&&a[3]||b!=h&&a[4]||M!=u&&a[5]||y!=f&&a[6]||R!=d&&a[7]||a[1];return l=m,c=g,h=b,u=M,f=y,d=R,S(x)})}}function j3(i,e){let t=dm(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function $p(i,e,t){return new Date(i,e,t)}function bv(i,e){return e(i)}var J3="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function vv(i,e){return(t,n,s,r)=>r==null?am:e(i(n))}function K3(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function Q3(i,e){return i.series[e].fill(i,e)}var eR={show:!0,live:!0,isolate:!1,mount:v3,markers:{show:!0,width:2,stroke:K3,fill:Q3,dash:"solid"},idx:null,idxs:null,values:[]};function tR(i,e){let t=i.cursor.points,n=Wi(),s=t.size(i,e);Jt(n,Fl,s),Jt(n,Ol,s);let r=s/-2;Jt(n,"marginLeft",r),Jt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Jt(n,"borderWidth",o),n}function nR(i,e){let t=i.series[e].points;return t._fill||t._stroke}function iR(i,e){let t=i.series[e].points;return t._stroke||t._fill}function sR(i,e){return i.series[e].points.size}var Yp=[0,0];function rR(i,e,t){return Yp[0]=e,Yp[1]=t,Yp}function $u(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Zp(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var oR={show:!0,x:!0,y:!0,lock:!1,move:rR,points:{one:!1,show:tR,size:sR,width:0,stroke:iR,fill:nR},bind:{mousedown:$u,mouseup:$u,click:$u,dblclick:$u,mousemove:Zp,mouseleave:Zp,mouseenter:Zp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Qv={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},mm=Sn({},Qv,{filter:Bv}),ey=Sn({},mm,{size:10}),ty=Sn({},Qv,{show:!1}),gm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',ny="bold "+gm,iy=1.5,yv={show:!0,scale:"x",stroke:om,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:ny,side:2,grid:mm,ticks:ey,border:ty,font:gm,lineGap:iy,rotate:0},aR="Value",lR="Time",_v={show:!0,scale:"x",auto:!1,sorted:1,min:Ht,max:-Ht,idxs:[]};function cR(i,e,t,n,s){return e.map(r=>r==null?"":um(r))}function hR(i,e,t,n,s,r,o){let a=[],l=Tr.get(s)||0;t=o?t:Vt(ef(t,s),l);for(let c=t;c<=n;c=Vt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function tm(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?er:Fv,h=Ii(c(t));s=oa(l,h),l==10&&(s=Jr[rs(s,Jr)]);let u=t,f=s*l;l==10&&(f=Jr[rs(f,Jr)]);do a.push(u),u=u+s,l==10&&!Tr.has(u)&&(u=Vt(u,Tr.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=Jr[rs(f,Jr)]));while(u<=n);return a}function uR(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?tm(i,e,ci(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?tm(i,e,ci(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(h,c)}var sy=/./,fR=/[12357]/,dR=/[125]/,Mv=/1/,nm=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function pR(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?sy:l(7,o)-h>=c?fR:l(5,o)-h>=c?dR:Mv;if(u==Mv){let f=In(l(1,o)-h);if(f<c)return nm(e.slice().reverse(),a.distr,u,Xi(c/f)).reverse()}return nm(e,a.distr,u,1)}function mR(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=In(l(1,o)-l(2,o));return c<a?nm(e.slice().reverse(),3,sy,Xi(a/c)).reverse():e}function gR(i,e,t,n){return n==null?am:e==null?"":um(e)}var wv={show:!0,scale:"y",stroke:om,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:ny,side:3,grid:mm,ticks:ey,border:ty,font:gm,lineGap:iy,rotate:0};function xR(i,e){let t=3+(i||1)*2;return Vt(t*e,3)}function bR(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=In(o-r),l=i.series[e],c=a/(l.points.space*Ct);return n[1]-n[0]<=c}var Sv={scale:null,auto:!0,sorted:0,min:Ht,max:-Ht},ry=(i,e,t,n,s)=>s,Ev={show:!0,auto:!0,sorted:0,gaps:ry,alpha:1,facets:[Sn({},Sv,{scale:"x"}),Sn({},Sv,{scale:"y"})]},Tv={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:ry,alpha:1,points:{show:bR,filter:null},values:null,min:Ht,max:-Ht,idxs:[],path:null,clip:null};function vR(i,e,t,n,s){return t/10}var oy={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},yR=Sn({},oy,{time:!1,ori:1}),Av={};function ay(i,e){let t=Av[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Av[i]=t)),t}var ca=1,im=2;function to(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,p=a.width,x=a.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,g,f,d,p,x,sf,ua,of,cy,uy):t(s,l,c,h,u,g,m,d,f,x,p,rf,fa,vm,hy,fy)}function xm(i,e){let t=0,n=0,s=Et(i.bands,fm);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function _R(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function tr(i,e,t,n,s,r){return to(i,e,(o,a,l,c,h,u,f,d,p,x,m)=>{let g=o.pxRound,b=c.dir*(c.ori==0?1:-1),M=c.ori==0?ua:fa,y,R;b==1?(y=t,R=n):(y=n,R=t);let S=g(u(a[y],c,x,d)),v=g(f(l[y],h,m,p)),w=g(u(a[R],c,x,d)),C=g(f(r==1?h.max:h.min,h,m,p)),P=new Path2D(s);return M(P,w,C),M(P,S,C),M(P,S,v),P})}function nf(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?of:vm,l=t;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function MR(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function bm(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(i[u]),p=f==u?d:r(i[f]),x=u-s;d=o<=0&&x>=0&&x<l?r(i[x]):d;let g=f+s;p=o>=0&&g>=0&&g<l?r(i[g]):p,p>=d&&a.push([d,p])}return a}function Rv(i){return i==0?kv:i==1?Pn:e=>jr(e,i)}function ly(i){let e=i==0?sf:rf,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=os(c,a/2,l/2),h=os(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var sf=(i,e,t)=>{i.moveTo(e,t)},rf=(i,e,t)=>{i.moveTo(t,e)},ua=(i,e,t)=>{i.lineTo(e,t)},fa=(i,e,t)=>{i.lineTo(t,e)},of=ly(0),vm=ly(1),cy=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},hy=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},uy=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},fy=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function dy(i){return(e,t,n,s,r)=>to(e,t,(o,a,l,c,h,u,f,d,p,x,m)=>{let{pxRound:g,points:b}=o,M,y;c.ori==0?(M=sf,y=cy):(M=rf,y=hy);let R=Vt(b.width*Ct,3),S=(b.size-b.width)/2*Ct,v=Vt(S*2,3),w=new Path2D,C=new Path2D,{left:P,top:I,width:O,height:z}=e.bbox;of(C,P-v,I-v,O+v*2,z+v*2);let U=G=>{if(l[G]!=null){let q=g(u(a[G],c,x,d)),H=g(f(l[G],h,m,p));M(w,q+S,H),y(w,q,H,S,0,Yu*2)}};if(r)r.forEach(U);else for(let G=n;G<=s;G++)U(G);return{stroke:R>0?w:null,fill:w,clip:C,flags:ca|im}})}function py(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var wR=py(ua),SR=py(fa);function my(i){let e=Et(i?.alignGaps,0);return(t,n,s,r)=>to(t,n,(o,a,l,c,h,u,f,d,p,x,m)=>{[s,r]=Ku(l,s,r);let g=o.pxRound,b=z=>g(u(z,c,x,d)),M=z=>g(f(z,h,m,p)),y,R;c.ori==0?(y=ua,R=wR):(y=fa,R=SR);let S=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ca},w=v.stroke,C=!1;if(r-s>=x*4){let z=ce=>t.posToVal(ce,c.key,!0),U=null,G=null,q,H,ae,Y=b(a[S==1?s:r]),ee=b(a[s]),te=b(a[r]),de=z(S==1?ee+1:te-1);for(let ce=S==1?s:r;ce>=s&&ce<=r;ce+=S){let J=a[ce],ge=(S==1?J<de:J>de)?Y:b(J),Se=l[ce];ge==Y?Se!=null?(H=Se,U==null?(y(w,ge,M(H)),q=U=G=H):H<U?U=H:H>G&&(G=H)):Se===null&&(C=!0):(U!=null&&R(w,Y,M(U),M(G),M(q),M(H)),Se!=null?(H=Se,y(w,ge,M(H)),U=G=q=H):(U=G=null,Se===null&&(C=!0)),Y=ge,de=z(Y+S))}U!=null&&U!=G&&ae!=Y&&R(w,Y,M(U),M(G),M(q),M(H))}else for(let z=S==1?s:r;z>=s&&z<=r;z+=S){let U=l[z];U===null?C=!0:U!=null&&y(w,b(a[z]),M(U))}let[I,O]=xm(t,n);if(o.fill!=null||I!=0){let z=v.fill=new Path2D(w),U=o.fillTo(t,n,o.min,o.max,I),G=M(U),q=b(a[s]),H=b(a[r]);S==-1&&([H,q]=[q,H]),y(z,H,G),y(z,q,G)}if(!o.spanGaps){let z=[];C&&z.push(...bm(a,l,s,r,S,b,e)),v.gaps=z=o.gaps(t,n,s,r,z),v.clip=nf(z,c.ori,d,p,x,m)}return O!=0&&(v.band=O==2?[tr(t,n,s,r,w,-1),tr(t,n,s,r,w,1)]:tr(t,n,s,r,w,O)),v})}function ER(i){let e=Et(i.align,1),t=Et(i.ascDesc,!1),n=Et(i.alignGaps,0),s=Et(i.extend,!1);return(r,o,a,l)=>to(r,o,(c,h,u,f,d,p,x,m,g,b,M)=>{[a,l]=Ku(u,a,l);let y=c.pxRound,{left:R,width:S}=r.bbox,v=ee=>y(p(ee,f,b,m)),w=ee=>y(x(ee,d,M,g)),C=f.ori==0?ua:fa,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ca},I=P.stroke,O=f.dir*(f.ori==0?1:-1),z=w(u[O==1?a:l]),U=v(h[O==1?a:l]),G=U,q=U;s&&e==-1&&(q=R,C(I,q,z)),C(I,U,z);for(let ee=O==1?a:l;ee>=a&&ee<=l;ee+=O){let te=u[ee];if(te==null)continue;let de=v(h[ee]),ce=w(te);e==1?C(I,de,z):C(I,G,ce),C(I,de,ce),z=ce,G=de}let H=G;s&&e==1&&(H=R+S,C(I,H,z));let[ae,Y]=xm(r,o);if(c.fill!=null||ae!=0){let ee=P.fill=new Path2D(I),te=c.fillTo(r,o,c.min,c.max,ae),de=w(te);C(ee,H,de),C(ee,q,de)}if(!c.spanGaps){let ee=[];ee.push(...bm(h,u,a,l,O,v,n));let te=c.width*Ct/2,de=t||e==1?te:-te,ce=t||e==-1?-te:te;ee.forEach(J=>{J[0]+=de,J[1]+=ce}),P.gaps=ee=c.gaps(r,o,a,l,ee),P.clip=nf(ee,f.ori,m,g,b,M)}return Y!=0&&(P.band=Y==2?[tr(r,o,a,l,I,-1),tr(r,o,a,l,I,1)]:tr(r,o,a,l,I,Y)),P})}function Cv(i,e,t,n,s,r,o=Ht){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=In(i[l]-i[a]);h<c&&(c=h,o=In(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function TR(i){i=i||zl;let e=Et(i.size,[.6,Ht,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=Et(e[1],Ht),l=Et(e[2],1),c=Et(i.disp,zl),h=Et(i.each,d=>{}),{fill:u,stroke:f}=c;return(d,p,x,m)=>to(d,p,(g,b,M,y,R,S,v,w,C,P,I)=>{let O=g.pxRound,z=t,U=n*Ct,G=a*Ct,q=l*Ct,H,ae;y.ori==0?[H,ae]=r(d,p):[ae,H]=r(d,p);let Y=y.dir*(y.ori==0?1:-1),ee=y.ori==0?of:vm,te=y.ori==0?h:(Pe,Ze,at,Ee,Bt,Ve,$e)=>{h(Pe,Ze,at,Bt,Ee,$e,Ve)},de=Et(d.bands,fm).find(Pe=>Pe.series[0]==p),ce=de!=null?de.dir:0,J=g.fillTo(d,p,g.min,g.max,ce),ue=O(v(J,R,I,C)),ge,Se,be,Ge=P,tt=O(g.width*Ct),He=!1,lt=null,ot=null,je=null,Kt=null;u!=null&&(tt==0||f!=null)&&(He=!0,lt=u.values(d,p,x,m),ot=new Map,new Set(lt).forEach(Pe=>{Pe!=null&&ot.set(Pe,new Path2D)}),tt>0&&(je=f.values(d,p,x,m),Kt=new Map,new Set(je).forEach(Pe=>{Pe!=null&&Kt.set(Pe,new Path2D)})));let{x0:Gt,size:gn}=c;if(Gt!=null&&gn!=null){z=1,b=Gt.values(d,p,x,m),Gt.unit==2&&(b=b.map(at=>d.posToVal(w+at*P,y.key,!0)));let Pe=gn.values(d,p,x,m);gn.unit==2?Se=Pe[0]*P:Se=S(Pe[0],y,P,w)-S(0,y,P,w),Ge=Cv(b,M,S,y,P,w,Ge),be=Ge-Se+U}else Ge=Cv(b,M,S,y,P,w,Ge),be=Ge*o+U,Se=Ge-be;be<1&&(be=0),tt>=Se/2&&(tt=0),be<5&&(O=kv);let Ut=be>0,Ln=Ge-be-(Ut?tt:0);Se=O(em(Ln,q,G)),ge=(z==0?Se/2:z==Y?0:Se)-z*Y*((z==0?U/2:0)+(Ut?tt/2:0));let _t={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},En=He?null:new Path2D,on=null;if(de!=null)on=d.data[de.series[1]];else{let{y0:Pe,y1:Ze}=c;Pe!=null&&Ze!=null&&(M=Ze.values(d,p,x,m),on=Pe.values(d,p,x,m))}let xn=H*Se,B=ae*Se;for(let Pe=Y==1?x:m;Pe>=x&&Pe<=m;Pe+=Y){let Ze=M[Pe];if(Ze==null)continue;if(on!=null){let X=on[Pe]??0;if(Ze-X==0)continue;ue=v(X,R,I,C)}let at=y.distr!=2||c!=null?b[Pe]:Pe,Ee=S(at,y,P,w),Bt=v(Et(Ze,J),R,I,C),Ve=O(Ee-ge),$e=O(ci(Bt,ue)),L=O(os(Bt,ue)),E=$e-L;if(Ze!=null){let X=Ze<0?B:xn,fe=Ze<0?xn:B;He?(tt>0&&je[Pe]!=null&&ee(Kt.get(je[Pe]),Ve,L+Ii(tt/2),Se,ci(0,E-tt),X,fe),lt[Pe]!=null&&ee(ot.get(lt[Pe]),Ve,L+Ii(tt/2),Se,ci(0,E-tt),X,fe)):ee(En,Ve,L+Ii(tt/2),Se,ci(0,E-tt),X,fe),te(d,p,Pe,Ve-tt/2,L,Se+tt,E)}}return tt>0?_t.stroke=He?Kt:En:He||(_t._fill=g.width==0?g._fill:g._stroke??g._fill,_t.width=0),_t.fill=He?ot:En,_t})}function AR(i,e){let t=Et(e?.alignGaps,0);return(n,s,r,o)=>to(n,s,(a,l,c,h,u,f,d,p,x,m,g)=>{[r,o]=Ku(c,r,o);let b=a.pxRound,M=H=>b(f(H,h,m,p)),y=H=>b(d(H,u,g,x)),R,S,v;h.ori==0?(R=sf,v=ua,S=uy):(R=rf,v=fa,S=fy);let w=h.dir*(h.ori==0?1:-1),C=M(l[w==1?r:o]),P=C,I=[],O=[];for(let H=w==1?r:o;H>=r&&H<=o;H+=w)if(c[H]!=null){let Y=l[H],ee=M(Y);I.push(P=ee),O.push(y(c[H]))}let z={stroke:i(I,O,R,v,S,b),fill:null,clip:null,band:null,gaps:null,flags:ca},U=z.stroke,[G,q]=xm(n,s);if(a.fill!=null||G!=0){let H=z.fill=new Path2D(U),ae=a.fillTo(n,s,a.min,a.max,G),Y=y(ae);v(H,P,Y),v(H,C,Y)}if(!a.spanGaps){let H=[];H.push(...bm(l,c,r,o,w,M,t)),z.gaps=H=a.gaps(n,s,r,o,H),z.clip=nf(H,h.ori,p,x,m,g)}return q!=0&&(z.band=q==2?[tr(n,s,r,o,U,-1),tr(n,s,r,o,U,1)]:tr(n,s,r,o,U,q)),z})}function RR(i){return AR(CR,i)}function CR(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=e[f+1]-e[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,e[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,e[f+1]-l[f+1]*u[f]/3,i[f+1],e[f+1])}return a}var sm=new Set;function Pv(){for(let i of sm)i.syncRect(!0)}ha&&(Qr(c3,ra,Pv),Qr(h3,ra,Pv,!0),Qr(Zu,ra,()=>{zn.pxRatio=Ct}));var PR=my(),IR=dy();function Iv(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>rm(r,o,e,t))}function LR(i,e){return i.map((t,n)=>n==0?{}:Sn({},e,t))}function rm(i,e,t,n){return Sn({},e==0?t:n,i)}function gy(i,e,t){return e==null?aa:[e,t]}var DR=gy;function NR(i,e,t){return e==null?aa:ju(e,t,hm,!0)}function xy(i,e,t,n){return e==null?aa:Qu(e,t,i.scales[n].log,!1)}var UR=xy;function by(i,e,t,n){return e==null?aa:cm(e,t,i.scales[n].log,!1)}var FR=by;function OR(i,e,t,n,s){let r=ci(cv(i),cv(e)),o=e-i,a=rs(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Tr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Lv(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Pn((t=+s)*Ct))+"px"),[i,e,t]}function kR(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Vt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function zn(i,e,t){let n={mode:Et(i.mode,1)},s=n.mode;function r(_,T,D,F){let W=T.valToPct(_);return F+D*(T.dir==-1?1-W:W)}function o(_,T,D,F){let W=T.valToPct(_);return F+D*(T.dir==-1?W:1-W)}function a(_,T,D,F){return T.ori==0?r(_,T,D,F):o(_,T,D,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Wi(X2);if(i.id!=null&&(c.id=i.id),Pi(c,i.class),i.title){let _=Wi(Y2,c);_.textContent=i.title}let h=ss("canvas"),u=n.ctx=h.getContext("2d"),f=Wi(Z2,c);Qr("click",f,_=>{_.target===p&&(qt!=lo||Qt!=co)&&Hn.click(n,_)},!0);let d=n.under=Wi(j2,f);f.appendChild(h);let p=n.over=Wi(J2,f);i=la(i);let x=+Et(i.pxAlign,1),m=Rv(x);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let g=i.ms||.001,b=n.series=s==1?Iv(i.series||[],_v,Tv,!1):LR(i.series||[null],Ev),M=n.axes=Iv(i.axes||[],yv,wv,!0),y=n.scales={},R=n.bands=i.bands||[];R.forEach(_=>{_.fill=yt(_.fill||null),_.dir=Et(_.dir,-1)});let S=s==2?b[1].facets[0].scale:b[0].scale,v={axes:Ps,series:mt},w=(i.drawOrder||["axes","series"]).map(_=>v[_]);function C(_){let T=_.distr==3?D=>er(D>0?D:_.clamp(n,D,_.min,_.max,_.key)):_.distr==4?D=>qp(D,_.asinh):_.distr==100?D=>_.fwd(D):D=>D;return D=>{let F=T(D),{_min:W,_max:j}=_,le=j-W;return(F-W)/le}}function P(_){let T=y[_];if(T==null){let D=(i.scales||zl)[_]||zl;if(D.from!=null){P(D.from);let F=Sn({},y[D.from],D,{key:_});F.valToPct=C(F),y[_]=F}else{T=y[_]=Sn({},_==S?oy:yR,D),T.key=_;let F=T.time,W=T.range,j=Er(W);if((_!=S||s==2&&!F)&&(j&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?ov:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?ov:{mode:1,hard:W[1],soft:W[1]}},j=!1),!j&&tf(W))){let le=W;W=(pe,_e,Ne)=>_e==null?aa:ju(_e,Ne,le)}T.range=yt(W||(F?DR:_==S?T.distr==3?UR:T.distr==4?FR:gy:T.distr==3?xy:T.distr==4?by:NR)),T.auto=yt(j?!1:T.auto),T.clamp=yt(T.clamp||vR),T._min=T._max=null,T.valToPct=C(T)}}}P("x"),P("y"),s==1&&b.forEach(_=>{P(_.scale)}),M.forEach(_=>{P(_.scale)});for(let _ in i.scales)P(_);let I=y[S],O=I.distr,z,U;I.ori==0?(Pi(c,q2),z=r,U=o):(Pi(c,$2),z=o,U=r);let G={};for(let _ in y){let T=y[_];(T.min!=null||T.max!=null)&&(G[_]={min:T.min,max:T.max},T.min=T.max=null)}let q=i.tzDate||(_=>new Date(Pn(_/g))),H=i.fmtDate||dm,ae=g==1?q3(q):Z3(q),Y=xv(q,gv(g==1?X3:Y3,H)),ee=vv(q,bv(J3,H)),te=[],de=n.legend=Sn({},eR,i.legend),ce=n.cursor=Sn({},oR,{drag:{y:s==2}},i.cursor),J=de.show,ue=ce.show,ge=de.markers;de.idxs=te,ge.width=yt(ge.width),ge.dash=yt(ge.dash),ge.stroke=yt(ge.stroke),ge.fill=yt(ge.fill);let Se,be,Ge,tt=[],He=[],lt,ot=!1,je={};if(de.live){let _=b[1]?b[1].values:null;ot=_!=null,lt=ot?_(n,1,0):{_:0};for(let T in lt)je[T]=am}if(J)if(Se=ss("table",i3,c),Ge=ss("tbody",null,Se),de.mount(n,Se),ot){be=ss("thead",null,Se,Ge);let _=ss("tr",null,be);ss("th",null,_);for(var Kt in lt)ss("th",$b,_).textContent=Kt}else Pi(Se,r3),de.live&&Pi(Se,s3);let Gt={show:!0},gn={show:!1};function Ut(_,T){if(T==0&&(ot||!de.live||s==2))return aa;let D=[],F=ss("tr",o3,Ge,Ge.childNodes[T]);Pi(F,_.class),_.show||Pi(F,Kr);let W=ss("th",null,F);if(ge.show){let pe=Wi(a3,W);if(T>0){let _e=ge.width(n,T);_e&&(pe.style.border=_e+"px "+ge.dash(n,T)+" "+ge.stroke(n,T)),pe.style.background=ge.fill(n,T)}}let j=Wi($b,W);_.label instanceof HTMLElement?j.appendChild(_.label):j.textContent=_.label,T>0&&(ge.show||(j.style.color=_.width>0?ge.stroke(n,T):ge.fill(n,T)),_t("click",W,pe=>{if(ce._lock)return;Ke(pe);let _e=b.indexOf(_);if((pe.ctrlKey||pe.metaKey)!=de.isolate){let Ne=b.some((Ue,Oe)=>Oe>0&&Oe!=_e&&Ue.show);b.forEach((Ue,Oe)=>{Oe>0&&hs(Oe,Ne?Oe==_e?Gt:gn:Gt,!0,_n.setSeries)})}else hs(_e,{show:!_.show},!0,_n.setSeries)},!1),Qe&&_t(Jb,W,pe=>{ce._lock||(Ke(pe),hs(b.indexOf(_),uo,!0,_n.setSeries))},!1));for(var le in lt){let pe=ss("td",l3,F);pe.textContent="--",D.push(pe)}return[F,D]}let Ln=new Map;function _t(_,T,D,F=!0){let W=Ln.get(T)||{},j=ce.bind[_](n,T,D,F);j&&(Qr(_,T,W[_]=j),Ln.set(T,W))}function En(_,T,D){let F=Ln.get(T)||{};for(let W in F)(_==null||W==_)&&(Qp(W,T,F[W]),delete F[W]);_==null&&Ln.delete(T)}let on=0,xn=0,B=0,Pe=0,Ze=0,at=0,Ee=Ze,Bt=at,Ve=B,$e=Pe,L=0,E=0,X=0,fe=0;n.bbox={};let oe=!1,ve=!1,ye=!1,ne=!1,se=!1,me=!1;function k(_,T,D){(D||_!=n.width||T!=n.height)&&re(_,T),ut(!1),ye=!0,ve=!0,$n()}function re(_,T){n.width=on=B=_,n.height=xn=Pe=T,Ze=at=0,Me(),We();let D=n.bbox;L=D.left=jr(Ze*Ct,.5),E=D.top=jr(at*Ct,.5),X=D.width=jr(B*Ct,.5),fe=D.height=jr(Pe*Ct,.5)}let ie=3;function Te(){let _=!1,T=0;for(;!_;){T++;let D=ro(T),F=cs(T);_=T==ie||D&&F,_||(re(n.width,n.height),ve=!0)}}function xe({width:_,height:T}){k(_,T)}n.setSize=xe;function Me(){let _=!1,T=!1,D=!1,F=!1;M.forEach((W,j)=>{if(W.show&&W._show){let{side:le,_size:pe}=W,_e=le%2,Ne=W.label!=null?W.labelSize:0,Ue=pe+Ne;Ue>0&&(_e?(B-=Ue,le==3?(Ze+=Ue,F=!0):D=!0):(Pe-=Ue,le==0?(at+=Ue,_=!0):T=!0))}}),as[0]=_,as[1]=D,as[2]=T,as[3]=F,B-=qi[1]+qi[3],Ze+=qi[3],Pe-=qi[2]+qi[0],at+=qi[0]}function We(){let _=Ze+B,T=at+Pe,D=Ze,F=at;function W(j,le){switch(j){case 1:return _+=le,_-le;case 2:return T+=le,T-le;case 3:return D-=le,D+le;case 0:return F-=le,F+le}}M.forEach((j,le)=>{if(j.show&&j._show){let pe=j.side;j._pos=W(pe,j._size),j.label!=null&&(j._lpos=W(pe,j.labelSize))}})}if(ce.dataIdx==null){let _=ce.hover,T=_.skip=new Set(_.skip??[]);T.add(void 0);let D=_.prox=yt(_.prox),F=_.bias??=0;ce.dataIdx=(W,j,le,pe)=>{if(j==0)return le;let _e=le,Ne=D(W,j,le,pe)??Ht,Ue=Ne>=0&&Ne<Ht,Oe=I.ori==0?B:Pe,st=ce.left,Tt=e[0],St=e[j];if(T.has(St[le])){_e=null;let gt=null,Je=null,Xe;if(F==0||F==-1)for(Xe=le;gt==null&&Xe-- >0;)T.has(St[Xe])||(gt=Xe);if(F==0||F==1)for(Xe=le;Je==null&&Xe++<St.length;)T.has(St[Xe])||(Je=Xe);if(gt!=null||Je!=null)if(Ue){let Yt=gt==null?-1/0:z(Tt[gt],I,Oe,0),cn=Je==null?1/0:z(Tt[Je],I,Oe,0),Fn=st-Yt,Ft=cn-st;Fn<=Ft?Fn<=Ne&&(_e=gt):Ft<=Ne&&(_e=Je)}else _e=Je==null?gt:gt==null?Je:le-gt<=Je-le?gt:Je}else Ue&&In(st-z(Tt[le],I,Oe,0))>Ne&&(_e=null);return _e}}let Ke=_=>{ce.event=_};ce.idxs=te,ce._lock=!1;let he=ce.points;he.show=yt(he.show),he.size=yt(he.size),he.stroke=yt(he.stroke),he.width=yt(he.width),he.fill=yt(he.fill);let ke=n.focus=Sn({},i.focus||{alpha:.3},ce.focus),Qe=ke.prox>=0,Ce=Qe&&he.one,ct=[],Xt=[],ei=[];function pa(_,T){let D=he.show(n,T);if(D instanceof HTMLElement)return Pi(D,n3),Pi(D,_.class),Ts(D,-10,-10,B,Pe),p.insertBefore(D,ct[T]),D}function no(_,T){if(s==1||T>0){let D=s==1&&y[_.scale].time,F=_.value;_.value=D?fv(F)?vv(q,bv(F,H)):F||ee:F||gR,_.label=_.label||(D?lR:aR)}if(Ce||T>0){_.width=_.width==null?1:_.width,_.paths=_.paths||PR||y3,_.fillTo=yt(_.fillTo||_R),_.pxAlign=+Et(_.pxAlign,x),_.pxRound=Rv(_.pxAlign),_.stroke=yt(_.stroke||null),_.fill=yt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let D=xR(ci(1,_.width),1),F=_.points=Sn({},{size:D,width:ci(1,D*.2),stroke:_.stroke,space:D*2,paths:IR,_stroke:null,_fill:null},_.points);F.show=yt(F.show),F.filter=yt(F.filter),F.fill=yt(F.fill),F.stroke=yt(F.stroke),F.paths=yt(F.paths),F.pxAlign=_.pxAlign}if(J){let D=Ut(_,T);tt.splice(T,0,D[0]),He.splice(T,0,D[1]),de.values.push(null)}if(ue){te.splice(T,0,null);let D=null;Ce?T==0&&(D=pa(_,T)):T>0&&(D=pa(_,T)),ct.splice(T,0,D),Xt.splice(T,0,0),ei.splice(T,0,0)}Un("addSeries",T)}function xf(_,T){T=T??b.length,_=s==1?rm(_,T,_v,Tv):rm(_,T,{},Ev),b.splice(T,0,_),no(b[T],T)}n.addSeries=xf;function Gl(_){if(b.splice(_,1),J){de.values.splice(_,1),He.splice(_,1);let T=tt.splice(_,1)[0];En(null,T.firstChild),T.remove()}ue&&(te.splice(_,1),ct.splice(_,1)[0].remove(),Xt.splice(_,1),ei.splice(_,1)),Un("delSeries",_)}n.delSeries=Gl;let as=[!1,!1,!1,!1];function As(_,T){if(_._show=_.show,_.show){let D=_.side%2,F=y[_.scale];F==null&&(_.scale=D?b[1].scale:S,F=y[_.scale]);let W=F.time;_.size=yt(_.size),_.space=yt(_.space),_.rotate=yt(_.rotate),Er(_.incrs)&&_.incrs.forEach(le=>{!Tr.has(le)&&Tr.set(le,Hv(le))}),_.incrs=yt(_.incrs||(F.distr==2?V3:W?g==1?W3:$3:Jr)),_.splits=yt(_.splits||(W&&F.distr==1?ae:F.distr==3?tm:F.distr==4?uR:hR)),_.stroke=yt(_.stroke),_.grid.stroke=yt(_.grid.stroke),_.ticks.stroke=yt(_.ticks.stroke),_.border.stroke=yt(_.border.stroke);let j=_.values;_.values=Er(j)&&!Er(j[0])?yt(j):W?Er(j)?xv(q,gv(j,H)):fv(j)?j3(q,j):j||Y:j||cR,_.filter=yt(_.filter||(F.distr>=3&&F.log==10?pR:F.distr==3&&F.log==2?mR:Bv)),_.font=Lv(_.font),_.labelFont=Lv(_.labelFont),_._size=_.size(n,null,T,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(as[T]=!0,_._el=Wi(K2,f))}}function Rs(_,T,D,F){let[W,j,le,pe]=D,_e=T%2,Ne=0;return _e==0&&(pe||j)&&(Ne=T==0&&!W||T==2&&!le?Pn(yv.size/3):0),_e==1&&(W||le)&&(Ne=T==1&&!j||T==3&&!pe?Pn(wv.size/2):0),Ne}let ma=n.padding=(i.padding||[Rs,Rs,Rs,Rs]).map(_=>yt(Et(_,Rs))),qi=n._padding=ma.map((_,T)=>_(n,T,as,0)),an,fn=null,dn=null,ls=s==1?b[0].idxs:null,bi=null,nr=!1;function ga(_,T){if(e=_??[],n.data=n._data=e,s==2){an=0;for(let D=1;D<b.length;D++)an+=e[D][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),bi=e[0],an=bi.length;let D=e;if(O==2){D=e.slice();let F=D[0]=Array(an);for(let W=0;W<an;W++)F[W]=W}n._data=e=D}if(ut(!0),Un("setData"),O==2&&(ye=!0),T!==!1){let D=I;D.auto(n,nr)?xa():rr(S,D.min,D.max),ne=ne||ce.left>=0,me=!0,$n()}}n.setData=ga;function xa(){nr=!0;let _,T;s==1&&(an>0?(fn=ls[0]=0,dn=ls[1]=an-1,_=e[0][fn],T=e[0][dn],O==2?(_=fn,T=dn):_==T&&(O==3?[_,T]=Qu(_,_,I.log,!1):O==4?[_,T]=cm(_,_,I.log,!1):I.time?T=_+Pn(86400/g):[_,T]=ju(_,T,hm,!0))):(fn=ls[0]=_=null,dn=ls[1]=T=null)),rr(S,_,T)}let io,ir,so,A,V,K,$,Z,Ae,Ie;function Re(_,T,D,F,W,j){_??=Zb,D??=fm,F??="butt",W??=Zb,j??="round",_!=io&&(u.strokeStyle=io=_),W!=ir&&(u.fillStyle=ir=W),T!=so&&(u.lineWidth=so=T),j!=V&&(u.lineJoin=V=j),F!=K&&(u.lineCap=K=F),D!=A&&u.setLineDash(A=D)}function Le(_,T,D,F){T!=ir&&(u.fillStyle=ir=T),_!=$&&(u.font=$=_),D!=Z&&(u.textAlign=Z=D),F!=Ae&&(u.textBaseline=Ae=F)}function ze(_,T,D,F,W=0){if(F.length>0&&_.auto(n,nr)&&(T==null||T.min==null)){let j=Et(fn,0),le=Et(dn,F.length-1),pe=D.min==null?p3(F,j,le,W,_.distr==3):[D.min,D.max];_.min=os(_.min,D.min=pe[0]),_.max=ci(_.max,D.max=pe[1])}}let nt={min:null,max:null};function pt(){for(let F in y){let W=y[F];G[F]==null&&(W.min==null||G[S]!=null&&W.auto(n,nr))&&(G[F]=nt)}for(let F in y){let W=y[F];G[F]==null&&W.from!=null&&G[W.from]!=null&&(G[F]=nt)}G[S]!=null&&ut(!0);let _={};for(let F in G){let W=G[F];if(W!=null){let j=_[F]=la(y[F],w3);if(W.min!=null)Sn(j,W);else if(F!=S||s==2)if(an==0&&j.from==null){let le=j.range(n,null,null,F);j.min=le[0],j.max=le[1]}else j.min=Ht,j.max=-Ht}}if(an>0){b.forEach((F,W)=>{if(s==1){let j=F.scale,le=G[j];if(le==null)return;let pe=_[j];if(W==0){let _e=pe.range(n,pe.min,pe.max,j);pe.min=_e[0],pe.max=_e[1],fn=rs(pe.min,e[0]),dn=rs(pe.max,e[0]),dn-fn>1&&(e[0][fn]<pe.min&&fn++,e[0][dn]>pe.max&&dn--),F.min=bi[fn],F.max=bi[dn]}else F.show&&F.auto&&ze(pe,le,F,e[W],F.sorted);F.idxs[0]=fn,F.idxs[1]=dn}else if(W>0&&F.show&&F.auto){let[j,le]=F.facets,pe=j.scale,_e=le.scale,[Ne,Ue]=e[W],Oe=_[pe],st=_[_e];Oe!=null&&ze(Oe,G[pe],j,Ne,j.sorted),st!=null&&ze(st,G[_e],le,Ue,le.sorted),F.min=le.min,F.max=le.max}});for(let F in _){let W=_[F],j=G[F];if(W.from==null&&(j==null||j.min==null)){let le=W.range(n,W.min==Ht?null:W.min,W.max==-Ht?null:W.max,F);W.min=le[0],W.max=le[1]}}}for(let F in _){let W=_[F];if(W.from!=null){let j=_[W.from];if(j.min==null)W.min=W.max=null;else{let le=W.range(n,j.min,j.max,F);W.min=le[0],W.max=le[1]}}}let T={},D=!1;for(let F in _){let W=_[F],j=y[F];if(j.min!=W.min||j.max!=W.max){j.min=W.min,j.max=W.max;let le=j.distr;j._min=le==3?er(j.min):le==4?qp(j.min,j.asinh):le==100?j.fwd(j.min):j.min,j._max=le==3?er(j.max):le==4?qp(j.max,j.asinh):le==100?j.fwd(j.max):j.max,T[F]=D=!0}}if(D){b.forEach((F,W)=>{s==2?W>0&&T.y&&(F._paths=null):T[F.scale]&&(F._paths=null)});for(let F in T)ye=!0,Un("setScale",F);ue&&ce.left>=0&&(ne=me=!0)}for(let F in G)G[F]=null}function Be(_){let T=em(fn-1,0,an-1),D=em(dn+1,0,an-1);for(;_[T]==null&&T>0;)T--;for(;_[D]==null&&D<an-1;)D++;return[T,D]}function mt(){if(an>0){let _=b.some(T=>T._focus)&&Ie!=ke.alpha;_&&(u.globalAlpha=Ie=ke.alpha),b.forEach((T,D)=>{if(D>0&&T.show&&(nn(D,!1),nn(D,!0),T._paths==null)){let F=Ie;Ie!=T.alpha&&(u.globalAlpha=Ie=T.alpha);let W=s==2?[0,e[D][0].length-1]:Be(e[D]);T._paths=T.paths(n,D,W[0],W[1]),Ie!=F&&(u.globalAlpha=Ie=F)}}),b.forEach((T,D)=>{if(D>0&&T.show){let F=Ie;Ie!=T.alpha&&(u.globalAlpha=Ie=T.alpha),T._paths!=null&&Lt(D,!1);{let W=T._paths!=null?T._paths.gaps:null,j=T.points.show(n,D,fn,dn,W),le=T.points.filter(n,D,j,W);(j||le)&&(T.points._paths=T.points.paths(n,D,fn,dn,le),Lt(D,!0))}Ie!=F&&(u.globalAlpha=Ie=F),Un("drawSeries",D)}}),_&&(u.globalAlpha=Ie=1)}}function nn(_,T){let D=T?b[_].points:b[_];D._stroke=D.stroke(n,_),D._fill=D.fill(n,_)}function Lt(_,T){let D=T?b[_].points:b[_],{stroke:F,fill:W,clip:j,flags:le,_stroke:pe=D._stroke,_fill:_e=D._fill,_width:Ne=D.width}=D._paths;Ne=Vt(Ne*Ct,3);let Ue=null,Oe=Ne%2/2;T&&_e==null&&(_e=Ne>0?"#fff":pe);let st=D.pxAlign==1&&Oe>0;if(st&&u.translate(Oe,Oe),!T){let Tt=L-Ne/2,St=E-Ne/2,gt=X+Ne,Je=fe+Ne;Ue=new Path2D,Ue.rect(Tt,St,gt,Je)}T?Fe(pe,Ne,D.dash,D.cap,_e,F,W,le,j):Dt(_,pe,Ne,D.dash,D.cap,_e,F,W,le,Ue,j),st&&u.translate(-Oe,-Oe)}function Dt(_,T,D,F,W,j,le,pe,_e,Ne,Ue){let Oe=!1;_e!=0&&R.forEach((st,Tt)=>{if(st.series[0]==_){let St=b[st.series[1]],gt=e[st.series[1]],Je=(St._paths||zl).band;Er(Je)&&(Je=st.dir==1?Je[0]:Je[1]);let Xe,Yt=null;St.show&&Je&&g3(gt,fn,dn)?(Yt=st.fill(n,Tt)||j,Xe=St._paths.clip):Je=null,Fe(T,D,F,W,Yt,le,pe,_e,Ne,Ue,Xe,Je),Oe=!0}}),Oe||Fe(T,D,F,W,j,le,pe,_e,Ne,Ue)}let Tn=ca|im;function Fe(_,T,D,F,W,j,le,pe,_e,Ne,Ue,Oe){Re(_,T,D,F,W),(_e||Ne||Oe)&&(u.save(),_e&&u.clip(_e),Ne&&u.clip(Ne)),Oe?(pe&Tn)==Tn?(u.clip(Oe),Ue&&u.clip(Ue),xt(W,le),bn(_,j,T)):pe&im?(xt(W,le),u.clip(Oe),bn(_,j,T)):pe&ca&&(u.save(),u.clip(Oe),Ue&&u.clip(Ue),xt(W,le),u.restore(),bn(_,j,T)):(xt(W,le),bn(_,j,T)),(_e||Ne||Oe)&&u.restore()}function bn(_,T,D){D>0&&(T instanceof Map?T.forEach((F,W)=>{u.strokeStyle=io=W,u.stroke(F)}):T!=null&&_&&u.stroke(T))}function xt(_,T){T instanceof Map?T.forEach((D,F)=>{u.fillStyle=ir=F,u.fill(D)}):T!=null&&_&&u.fill(T)}function Cs(_,T,D,F){let W=M[_],j;if(F<=0)j=[0,0];else{let le=W._space=W.space(n,_,T,D,F),pe=W._incrs=W.incrs(n,_,T,D,F,le);j=OR(T,D,pe,F,le)}return W._found=j}function vn(_,T,D,F,W,j,le,pe,_e,Ne){let Ue=le%2/2;x==1&&u.translate(Ue,Ue),Re(pe,le,_e,Ne,pe),u.beginPath();let Oe,st,Tt,St,gt=W+(F==0||F==3?-j:j);D==0?(st=W,St=gt):(Oe=W,Tt=gt);for(let Je=0;Je<_.length;Je++)T[Je]!=null&&(D==0?Oe=Tt=_[Je]:st=St=_[Je],u.moveTo(Oe,st),u.lineTo(Tt,St));u.stroke(),x==1&&u.translate(-Ue,-Ue)}function ro(_){let T=!0;return M.forEach((D,F)=>{if(!D.show)return;let W=y[D.scale];if(W.min==null){D._show&&(T=!1,D._show=!1,ut(!1));return}else D._show||(T=!1,D._show=!0,ut(!1));let j=D.side,le=j%2,{min:pe,max:_e}=W,[Ne,Ue]=Cs(F,pe,_e,le==0?B:Pe);if(Ue==0)return;let Oe=W.distr==2,st=D._splits=D.splits(n,F,pe,_e,Ne,Ue,Oe),Tt=W.distr==2?st.map(Xe=>bi[Xe]):st,St=W.distr==2?bi[st[1]]-bi[st[0]]:Ne,gt=D._values=D.values(n,D.filter(n,Tt,F,Ue,St),F,Ue,St);D._rotate=j==2?D.rotate(n,gt,F,Ue):0;let Je=D._size;D._size=Xi(D.size(n,gt,F,_)),Je!=null&&D._size!=Je&&(T=!1)}),T}function cs(_){let T=!0;return ma.forEach((D,F)=>{let W=D(n,F,as,_);W!=qi[F]&&(T=!1),qi[F]=W}),T}function Ps(){for(let _=0;_<M.length;_++){let T=M[_];if(!T.show||!T._show)continue;let D=T.side,F=D%2,W,j,le=T.stroke(n,_),pe=D==0||D==3?-1:1,[_e,Ne]=T._found;if(T.label!=null){let ii=T.labelGap*pe,_i=Pn((T._lpos+ii)*Ct);Le(T.labelFont[0],le,"center",D==2?"top":Yb),u.save(),F==1?(W=j=0,u.translate(_i,Pn(E+fe/2)),u.rotate((D==3?-Yu:Yu)/2)):(W=Pn(L+X/2),j=_i);let Pr=Ov(T.label)?T.label(n,_,_e,Ne):T.label;u.fillText(Pr,W,j),u.restore()}if(Ne==0)continue;let Ue=y[T.scale],Oe=F==0?X:fe,st=F==0?L:E,Tt=T._splits,St=Ue.distr==2?Tt.map(ii=>bi[ii]):Tt,gt=Ue.distr==2?bi[Tt[1]]-bi[Tt[0]]:_e,Je=T.ticks,Xe=T.border,Yt=Je.show?Je.size:0,cn=Pn(Yt*Ct),Fn=Pn((T.alignTo==2?T._size-Yt-T.gap:T.gap)*Ct),Ft=T._rotate*-Yu/180,hn=m(T._pos*Ct),vi=(cn+Fn)*pe,ni=hn+vi;j=F==0?ni:0,W=F==1?ni:0;let Di=T.font[0],$i=T.align==1?ia:T.align==2?Gp:Ft>0?ia:Ft<0?Gp:F==0?"center":D==3?Gp:ia,fs=Ft||F==1?"middle":D==2?"top":Yb;Le(Di,le,$i,fs);let yi=T.font[1]*T.lineGap,Ni=Tt.map(ii=>m(a(ii,Ue,Oe,st))),Yi=T._values;for(let ii=0;ii<Yi.length;ii++){let _i=Yi[ii];if(_i!=null){F==0?W=Ni[ii]:j=Ni[ii],_i=""+_i;let Pr=_i.indexOf(`
`)==-1?[_i]:_i.split(/\n/gm);for(let si=0;si<Pr.length;si++){let Gm=Pr[si];Ft?(u.save(),u.translate(W,j+si*yi),u.rotate(Ft),u.fillText(Gm,0,0),u.restore()):u.fillText(Gm,W,j+si*yi)}}}Je.show&&vn(Ni,Je.filter(n,St,_,Ne,gt),F,D,hn,cn,Vt(Je.width*Ct,3),Je.stroke(n,_),Je.dash,Je.cap);let ds=T.grid;ds.show&&vn(Ni,ds.filter(n,St,_,Ne,gt),F,F==0?2:1,F==0?E:L,F==0?fe:X,Vt(ds.width*Ct,3),ds.stroke(n,_),ds.dash,ds.cap),Xe.show&&vn([hn],[1],F==0?1:0,F==0?1:2,F==1?E:L,F==1?fe:X,Vt(Xe.width*Ct,3),Xe.stroke(n,_),Xe.dash,Xe.cap)}Un("drawAxes")}function ut(_){b.forEach((T,D)=>{D>0&&(T._paths=null,_&&(s==1?(T.min=null,T.max=null):T.facets.forEach(F=>{F.min=null,F.max=null})))})}let ln=!1,ti=!1,Nt=[];function yn(){ti=!1;for(let _=0;_<Nt.length;_++)Un(...Nt[_]);Nt.length=0}function $n(){ln||(P3(Em),ln=!0)}function Wl(_,T=!1){ln=!0,ti=T,_(n),Em(),T&&Nt.length>0&&queueMicrotask(yn)}n.batch=Wl;function Em(){if(oe&&(pt(),oe=!1),ye&&(Te(),ye=!1),ve){if(Jt(d,ia,Ze),Jt(d,"top",at),Jt(d,Fl,B),Jt(d,Ol,Pe),Jt(p,ia,Ze),Jt(p,"top",at),Jt(p,Fl,B),Jt(p,Ol,Pe),Jt(f,Fl,on),Jt(f,Ol,xn),h.width=Pn(on*Ct),h.height=Pn(xn*Ct),M.forEach(({_el:_,_show:T,_size:D,_pos:F,side:W})=>{if(_!=null)if(T){let j=W===3||W===0?D:0,le=W%2==1;Jt(_,le?"left":"top",F-j),Jt(_,le?"width":"height",D),Jt(_,le?"top":"left",le?at:Ze),Jt(_,le?"height":"width",le?Pe:B),Kp(_,Kr)}else Pi(_,Kr)}),io=ir=so=V=K=$=Z=Ae=A=null,Ie=1,ya(!0),Ze!=Ee||at!=Bt||B!=Ve||Pe!=$e){ut(!1);let _=B/Ve,T=Pe/$e;if(ue&&!ne&&ce.left>=0){ce.left*=_,ce.top*=T,oo&&Ts(oo,Pn(ce.left),0,B,Pe),ao&&Ts(ao,0,Pn(ce.top),B,Pe);for(let D=0;D<ct.length;D++){let F=ct[D];F!=null&&(Xt[D]*=_,ei[D]*=T,Ts(F,Xi(Xt[D]),Xi(ei[D]),B,Pe))}}if($t.show&&!se&&$t.left>=0&&$t.width>0){$t.left*=_,$t.width*=_,$t.top*=T,$t.height*=T;for(let D in wf)Jt(ho,D,$t[D])}Ee=Ze,Bt=at,Ve=B,$e=Pe}Un("setSize"),ve=!1}on>0&&xn>0&&(u.clearRect(0,0,h.width,h.height),Un("drawClear"),w.forEach(_=>_()),Un("draw")),$t.show&&se&&(Xl($t),se=!1),ue&&ne&&(Cr(null,!0,!1),ne=!1),de.show&&de.live&&me&&(_f(),me=!1),l||(l=!0,n.status=1,Un("ready")),nr=!1,ln=!1}n.redraw=(_,T)=>{ye=T||!1,_!==!1?rr(S,I.min,I.max):$n()};function bf(_,T){let D=y[_];if(D.from==null){if(an==0){let F=D.range(n,T.min,T.max,_);T.min=F[0],T.max=F[1]}if(T.min>T.max){let F=T.min;T.min=T.max,T.max=F}if(an>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;_==S&&D.distr==2&&an>0&&(T.min=rs(T.min,e[0]),T.max=rs(T.max,e[0]),T.min==T.max&&T.max++),G[_]=T,oe=!0,$n()}}n.setScale=bf;let vf,yf,oo,ao,Tm,Am,lo,co,Rm,Cm,qt,Qt,sr=!1,Hn=ce.drag,Dn=Hn.x,Nn=Hn.y;ue&&(ce.x&&(vf=Wi(e3,p)),ce.y&&(yf=Wi(t3,p)),I.ori==0?(oo=vf,ao=yf):(oo=yf,ao=vf),qt=ce.left,Qt=ce.top);let $t=n.select=Sn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),ho=$t.show?Wi(Q2,$t.over?p:d):null;function Xl(_,T){if($t.show){for(let D in _)$t[D]=_[D],D in wf&&Jt(ho,D,_[D]);T!==!1&&Un("setSelect")}}n.setSelect=Xl;function Ry(_){if(b[_].show)J&&Kp(tt[_],Kr);else if(J&&Pi(tt[_],Kr),ue){let D=Ce?ct[0]:ct[_];D!=null&&Ts(D,-10,-10,B,Pe)}}function rr(_,T,D){bf(_,{min:T,max:D})}function hs(_,T,D,F){T.focus!=null&&Dy(_),T.show!=null&&b.forEach((W,j)=>{j>0&&(_==j||_==null)&&(W.show=T.show,Ry(j),s==2?(rr(W.facets[0].scale,null,null),rr(W.facets[1].scale,null,null)):rr(W.scale,null,null),$n())}),D!==!1&&Un("setSeries",_,T),F&&_a("setSeries",n,_,T)}n.setSeries=hs;function Cy(_,T){Sn(R[_],T)}function Py(_,T){_.fill=yt(_.fill||null),_.dir=Et(_.dir,-1),T=T??R.length,R.splice(T,0,_)}function Iy(_){_==null?R.length=0:R.splice(_,1)}n.addBand=Py,n.setBand=Cy,n.delBand=Iy;function Ly(_,T){b[_].alpha=T,ue&&ct[_]!=null&&(ct[_].style.opacity=T),J&&tt[_]&&(tt[_].style.opacity=T)}let Is,or,Rr,uo={focus:!0};function Dy(_){if(_!=Rr){let T=_==null,D=ke.alpha!=1;b.forEach((F,W)=>{if(s==1||W>0){let j=T||W==0||W==_;F._focus=T?null:j,D&&Ly(W,j?1:ke.alpha)}}),Rr=_,D&&$n()}}J&&Qe&&_t(Kb,Se,_=>{ce._lock||(Ke(_),Rr!=null&&hs(null,uo,!0,_n.setSeries))});function us(_,T,D){let F=y[T];D&&(_=_/Ct-(F.ori==1?at:Ze));let W=B;F.ori==1&&(W=Pe,_=W-_),F.dir==-1&&(_=W-_);let j=F._min,le=F._max,pe=_/W,_e=j+(le-j)*pe,Ne=F.distr;return Ne==3?oa(10,_e):Ne==4?b3(_e,F.asinh):Ne==100?F.bwd(_e):_e}function Ny(_,T){let D=us(_,S,T);return rs(D,e[0],fn,dn)}n.valToIdx=_=>rs(_,e[0]),n.posToIdx=Ny,n.posToVal=us,n.valToPos=(_,T,D)=>y[T].ori==0?r(_,y[T],D?X:B,D?L:0):o(_,y[T],D?fe:Pe,D?E:0),n.setCursor=(_,T,D)=>{qt=_.left,Qt=_.top,Cr(null,T,D)};function Pm(_,T){Jt(ho,ia,$t.left=_),Jt(ho,Fl,$t.width=T)}function Im(_,T){Jt(ho,"top",$t.top=_),Jt(ho,Ol,$t.height=T)}let ba=I.ori==0?Pm:Im,va=I.ori==1?Pm:Im;function Uy(){if(J&&de.live)for(let _=s==2?1:0;_<b.length;_++){if(_==0&&ot)continue;let T=de.values[_],D=0;for(let F in T)He[_][D++].firstChild.nodeValue=T[F]}}function _f(_,T){if(_!=null&&(_.idxs?_.idxs.forEach((D,F)=>{te[F]=D}):M3(_.idx)||te.fill(_.idx),de.idx=te[0]),J&&de.live){for(let D=0;D<b.length;D++)(D>0||s==1&&!ot)&&Fy(D,te[D]);Uy()}me=!1,T!==!1&&Un("setLegend")}n.setLegend=_f;function Fy(_,T){let D=b[_],F=_==0&&O==2?bi:e[_],W;ot?W=D.values(n,_,T)??je:(W=D.value(n,T==null?null:F[T],_,T),W=W==null?je:{_:W}),de.values[_]=W}function Cr(_,T,D){Rm=qt,Cm=Qt,[qt,Qt]=ce.move(n,qt,Qt),ce.left=qt,ce.top=Qt,ue&&(oo&&Ts(oo,Pn(qt),0,B,Pe),ao&&Ts(ao,0,Pn(Qt),B,Pe));let F,W=fn>dn;Is=Ht,or=null;let j=I.ori==0?B:Pe,le=I.ori==1?B:Pe;if(qt<0||an==0||W){F=ce.idx=null;for(let pe=0;pe<b.length;pe++){let _e=ct[pe];_e!=null&&Ts(_e,-10,-10,B,Pe)}Qe&&hs(null,uo,!0,_==null&&_n.setSeries),de.live&&(te.fill(F),me=!0)}else{let pe,_e,Ne;s==1&&(pe=I.ori==0?qt:Qt,_e=us(pe,S),F=ce.idx=rs(_e,e[0],fn,dn),Ne=z(e[0][F],I,j,0));let Ue=-10,Oe=-10,st=0,Tt=0,St=!0,gt="",Je="";for(let Xe=s==2?1:0;Xe<b.length;Xe++){let Yt=b[Xe],cn=te[Xe],Fn=cn==null?null:s==1?e[Xe][cn]:e[Xe][1][cn],Ft=ce.dataIdx(n,Xe,F,_e),hn=Ft==null?null:s==1?e[Xe][Ft]:e[Xe][1][Ft];if(me=me||hn!=Fn||Ft!=cn,te[Xe]=Ft,Xe>0&&Yt.show){let vi=Ft==null?-10:Ft==F?Ne:z(s==1?e[0][Ft]:e[Xe][0][Ft],I,j,0),ni=hn==null?-10:U(hn,s==1?y[Yt.scale]:y[Yt.facets[1].scale],le,0);if(Qe&&hn!=null){let Di=I.ori==1?qt:Qt,$i=In(ke.dist(n,Xe,Ft,ni,Di));if($i<Is){let fs=ke.bias;if(fs!=0){let yi=us(Di,Yt.scale),Ni=hn>=0?1:-1,Yi=yi>=0?1:-1;Yi==Ni&&(Yi==1?fs==1?hn>=yi:hn<=yi:fs==1?hn<=yi:hn>=yi)&&(Is=$i,or=Xe)}else Is=$i,or=Xe}}if(me||Ce){let Di,$i;I.ori==0?(Di=vi,$i=ni):(Di=ni,$i=vi);let fs,yi,Ni,Yi,ds,ii,_i=!0,Pr=he.bbox;if(Pr!=null){_i=!1;let si=Pr(n,Xe);Ni=si.left,Yi=si.top,fs=si.width,yi=si.height}else Ni=Di,Yi=$i,fs=yi=he.size(n,Xe);if(ii=he.fill(n,Xe),ds=he.stroke(n,Xe),Ce)Xe==or&&Is<=ke.prox&&(Ue=Ni,Oe=Yi,st=fs,Tt=yi,St=_i,gt=ii,Je=ds);else{let si=ct[Xe];si!=null&&(Xt[Xe]=Ni,ei[Xe]=Yi,rv(si,fs,yi,_i),iv(si,ii,ds),Ts(si,Xi(Ni),Xi(Yi),B,Pe))}}}}if(Ce){let Xe=ke.prox,Yt=Rr==null?Is<=Xe:Is>Xe||or!=Rr;if(me||Yt){let cn=ct[0];cn!=null&&(Xt[0]=Ue,ei[0]=Oe,rv(cn,st,Tt,St),iv(cn,gt,Je),Ts(cn,Xi(Ue),Xi(Oe),B,Pe))}}}if($t.show&&sr)if(_!=null){let[pe,_e]=_n.scales,[Ne,Ue]=_n.match,[Oe,st]=_.cursor.sync.scales,Tt=_.cursor.drag;if(Dn=Tt._x,Nn=Tt._y,Dn||Nn){let{left:St,top:gt,width:Je,height:Xe}=_.select,Yt=_.scales[Oe].ori,cn=_.posToVal,Fn,Ft,hn,vi,ni,Di=pe!=null&&Ne(pe,Oe),$i=_e!=null&&Ue(_e,st);Di&&Dn?(Yt==0?(Fn=St,Ft=Je):(Fn=gt,Ft=Xe),hn=y[pe],vi=z(cn(Fn,Oe),hn,j,0),ni=z(cn(Fn+Ft,Oe),hn,j,0),ba(os(vi,ni),In(ni-vi))):ba(0,j),$i&&Nn?(Yt==1?(Fn=St,Ft=Je):(Fn=gt,Ft=Xe),hn=y[_e],vi=U(cn(Fn,st),hn,le,0),ni=U(cn(Fn+Ft,st),hn,le,0),va(os(vi,ni),In(ni-vi))):va(0,le)}else Sf()}else{let pe=In(Rm-Tm),_e=In(Cm-Am);if(I.ori==1){let st=pe;pe=_e,_e=st}Dn=Hn.x&&pe>=Hn.dist,Nn=Hn.y&&_e>=Hn.dist;let Ne=Hn.uni;Ne!=null?Dn&&Nn&&(Dn=pe>=Ne,Nn=_e>=Ne,!Dn&&!Nn&&(_e>pe?Nn=!0:Dn=!0)):Hn.x&&Hn.y&&(Dn||Nn)&&(Dn=Nn=!0);let Ue,Oe;Dn&&(I.ori==0?(Ue=lo,Oe=qt):(Ue=co,Oe=Qt),ba(os(Ue,Oe),In(Oe-Ue)),Nn||va(0,le)),Nn&&(I.ori==1?(Ue=lo,Oe=qt):(Ue=co,Oe=Qt),va(os(Ue,Oe),In(Oe-Ue)),Dn||ba(0,j)),!Dn&&!Nn&&(ba(0,0),va(0,0))}if(Hn._x=Dn,Hn._y=Nn,_==null){if(D){if(Vm!=null){let[pe,_e]=_n.scales;_n.values[0]=pe!=null?us(I.ori==0?qt:Qt,pe):null,_n.values[1]=_e!=null?us(I.ori==1?qt:Qt,_e):null}_a(Wp,n,qt,Qt,B,Pe,F)}if(Qe){let pe=D&&_n.setSeries,_e=ke.prox;Rr==null?Is<=_e&&hs(or,uo,!0,pe):Is>_e?hs(null,uo,!0,pe):or!=Rr&&hs(or,uo,!0,pe)}}me&&(de.idx=F,_f()),T!==!1&&Un("setCursor")}let ar=null;Object.defineProperty(n,"rect",{get(){return ar==null&&ya(!1),ar}});function ya(_=!1){_?ar=null:(ar=p.getBoundingClientRect(),Un("syncRect",ar))}function Lm(_,T,D,F,W,j,le){ce._lock||sr&&_!=null&&_.movementX==0&&_.movementY==0||(Mf(_,T,D,F,W,j,le,!1,_!=null),_!=null?Cr(null,!0,!0):Cr(T,!0,!1))}function Mf(_,T,D,F,W,j,le,pe,_e){if(ar==null&&ya(!1),Ke(_),_!=null)D=_.clientX-ar.left,F=_.clientY-ar.top;else{if(D<0||F<0){qt=-10,Qt=-10;return}let[Ne,Ue]=_n.scales,Oe=T.cursor.sync,[st,Tt]=Oe.values,[St,gt]=Oe.scales,[Je,Xe]=_n.match,Yt=T.axes[0].side%2==1,cn=I.ori==0?B:Pe,Fn=I.ori==1?B:Pe,Ft=Yt?j:W,hn=Yt?W:j,vi=Yt?F:D,ni=Yt?D:F;if(St!=null?D=Je(Ne,St)?a(st,y[Ne],cn,0):-10:D=cn*(vi/Ft),gt!=null?F=Xe(Ue,gt)?a(Tt,y[Ue],Fn,0):-10:F=Fn*(ni/hn),I.ori==1){let Di=D;D=F,F=Di}}_e&&(T==null||T.cursor.event.type==Wp)&&((D<=1||D>=B-1)&&(D=jr(D,B)),(F<=1||F>=Pe-1)&&(F=jr(F,Pe))),pe?(Tm=D,Am=F,[lo,co]=ce.move(n,D,F)):(qt=D,Qt=F)}let wf={width:0,height:0,left:0,top:0};function Sf(){Xl(wf,!1)}let Dm,Nm,Um,Fm;function Om(_,T,D,F,W,j,le){sr=!0,Dn=Nn=Hn._x=Hn._y=!1,Mf(_,T,D,F,W,j,le,!0,!1),_!=null&&(_t(Xp,jp,km,!1),_a(jb,n,lo,co,B,Pe,null));let{left:pe,top:_e,width:Ne,height:Ue}=$t;Dm=pe,Nm=_e,Um=Ne,Fm=Ue}function km(_,T,D,F,W,j,le){sr=Hn._x=Hn._y=!1,Mf(_,T,D,F,W,j,le,!1,!0);let{left:pe,top:_e,width:Ne,height:Ue}=$t,Oe=Ne>0||Ue>0,st=Dm!=pe||Nm!=_e||Um!=Ne||Fm!=Ue;if(Oe&&st&&Xl($t),Hn.setScale&&Oe&&st){let Tt=pe,St=Ne,gt=_e,Je=Ue;if(I.ori==1&&(Tt=_e,St=Ue,gt=pe,Je=Ne),Dn&&rr(S,us(Tt,S),us(Tt+St,S)),Nn)for(let Xe in y){let Yt=y[Xe];Xe!=S&&Yt.from==null&&Yt.min!=Ht&&rr(Xe,us(gt+Je,Xe),us(gt,Xe))}Sf()}else ce.lock&&(ce._lock=!ce._lock,Cr(T,!0,_!=null));_!=null&&(En(Xp,jp),_a(Xp,n,qt,Qt,B,Pe,null))}function Oy(_,T,D,F,W,j,le){if(ce._lock)return;Ke(_);let pe=sr;if(sr){let _e=!0,Ne=!0,Ue=10,Oe,st;I.ori==0?(Oe=Dn,st=Nn):(Oe=Nn,st=Dn),Oe&&st&&(_e=qt<=Ue||qt>=B-Ue,Ne=Qt<=Ue||Qt>=Pe-Ue),Oe&&_e&&(qt=qt<lo?0:B),st&&Ne&&(Qt=Qt<co?0:Pe),Cr(null,!0,!0),sr=!1}qt=-10,Qt=-10,te.fill(null),Cr(null,!0,!0),pe&&(sr=pe)}function Bm(_,T,D,F,W,j,le){ce._lock||(Ke(_),xa(),Sf(),_!=null&&_a(Qb,n,qt,Qt,B,Pe,null))}function zm(){M.forEach(kR),k(n.width,n.height,!0)}Qr(Zu,ra,zm);let fo={};fo.mousedown=Om,fo.mousemove=Lm,fo.mouseup=km,fo.dblclick=Bm,fo.setSeries=(_,T,D,F)=>{let W=_n.match[2];D=W(n,T,D),D!=-1&&hs(D,F,!0,!1)},ue&&(_t(jb,p,Om),_t(Wp,p,Lm),_t(Jb,p,_=>{Ke(_),ya(!1)}),_t(Kb,p,Oy),_t(Qb,p,Bm),sm.add(n),n.syncRect=ya);let ql=n.hooks=i.hooks||{};function Un(_,T,D){ti?Nt.push([_,T,D]):_ in ql&&ql[_].forEach(F=>{F.call(null,n,T,D)})}(i.plugins||[]).forEach(_=>{for(let T in _.hooks)ql[T]=(ql[T]||[]).concat(_.hooks[T])});let Hm=(_,T,D)=>D,_n=Sn({key:null,setSeries:!1,filters:{pub:hv,sub:hv},scales:[S,b[1]?b[1].scale:null],match:[uv,uv,Hm],values:[null,null]},ce.sync);_n.match.length==2&&_n.match.push(Hm),ce.sync=_n;let Vm=_n.key,Ef=ay(Vm);function _a(_,T,D,F,W,j,le){_n.filters.pub(_,T,D,F,W,j,le)&&Ef.pub(_,T,D,F,W,j,le)}Ef.sub(n);function ky(_,T,D,F,W,j,le){_n.filters.sub(_,T,D,F,W,j,le)&&fo[_](null,T,D,F,W,j,le)}n.pub=ky;function By(){Ef.unsub(n),sm.delete(n),Ln.clear(),Qp(Zu,ra,zm),c.remove(),Se?.remove(),Un("destroy")}n.destroy=By;function Tf(){Un("init",i,e),ga(e||i.data,!1),G[S]?bf(S,G[S]):xa(),se=$t.show&&($t.width>0||$t.height>0),ne=me=!0,k(i.width,i.height)}return b.forEach(no),M.forEach(As),t?t instanceof HTMLElement?(t.appendChild(c),Tf()):t(n,Tf):Tf(),n}zn.assign=Sn;zn.fmtNum=um;zn.rangeNum=ju;zn.rangeLog=Qu;zn.rangeAsinh=cm;zn.orient=to;zn.pxRatio=Ct;zn.join=C3;zn.fmtDate=dm,zn.tzDate=z3;zn.sync=ay;{zn.addGap=MR,zn.clipGaps=nf;let i=zn.paths={points:dy};i.linear=my,i.stepped=ER,i.bars=TR,i.spline=RR}var af=["#2f7ed8","#e4572e","#2a9d5c","#9a5fc9","#d99a1c","#17a2b0","#c2448d","#7a7f87"],lf=class{constructor(e,t,n){this.runs=e;this.seek=t;this.lines=n;this.object=Q("section.plots",{"aria-label":"histories"},Q("div.plothead",{},this.bar,this.extra),this.body),new ResizeObserver(()=>this.resize()).observe(this.body),this.tabs()}runs;seek;lines;object;tab="histories";now=null;body=Q("div.charts");bar=Q("div.tabs",{role:"tablist"});extra=Q("span.extra");plots=[];curves=[];blockField="displacement";picked=null;stamp=0;tabs(){let e=[["histories","Histories"],["energy","Energy"],["block","Block"],["line","Line"]];this.bar.replaceChildren(...e.map(([t,n])=>Q("button",{role:"tab",type:"button","aria-selected":String(t===this.tab),onclick:()=>{this.open(t)}},n)))}async open(e){this.tab=e,this.tabs();let t=++this.stamp;if(this.extra.replaceChildren(),e==="block")return this.openBlock(t);if(e==="line")return this.openLine();let n=await Promise.all(this.runs.map(r=>r.table(e).catch(()=>null)));if(t!==this.stamp)return;this.curves=n.flatMap((r,o)=>r?VR(r,o>0):[]);let s=e==="histories"?'This run recorded no histories. Request them in the scene: [[outputs]] history = { field = "..." }':"This run has no energy.csv.";this.draw(s)}setPicked(e,t){this.picked=t===null?null:{run:e,id:t},this.tab==="block"&&this.open("block")}async openBlock(e){if(this.curves=[],!this.picked)return this.draw("Pick a block in the picture to see its history.");let{run:t,id:n}=this.picked,s=da(t);s.includes(this.blockField)||(this.blockField=s[0]??""),this.extra.replaceChildren(Q("span",{},`${t.called(n)}: `),hi(s.map(a=>[a,a]),this.blockField,a=>{this.blockField=a,this.open("block")},"field of the block")),this.draw("Reading the frames \u2026");let r=t.moments(),o=r.length>1&&r.every(a=>a.time===r[0].time);await t.history(n,this.blockField,(a,l)=>{if(e!==this.stamp)return!1;let c=r.slice(0,a.length).map(h=>o?h.step:h.time);return this.curves=[{name:this.blockField,unit:l,x:c,bySteps:o,values:[...a],dash:!1}],this.draw(""),!0})}changed(){this.tab==="line"&&this.object.offsetParent!==null&&this.openLine()}openLine(){let e=this.lines();this.extra.replaceChildren(),e.some(t=>t.parts.length>0)&&this.extra.append(Q("button",{type:"button",title:"The values as a table (CSV)",onclick:()=>lr(new Blob([zR(e)],{type:"text/csv"}),HR(e))},"CSV")),this.curves=e.filter(t=>t.parts.length>0).map(BR),this.draw("Press d and click two points of the picture to see the field along the line between them.")}mark(e){this.now=e;for(let t of this.plots)t.redraw(!1)}draw(e){for(let n of this.plots)n.destroy();if(this.plots=[],this.body.replaceChildren(),this.curves.length===0){this.body.append(Q("p.hint",{},e));return}let t=new Map;for(let n of this.curves){let s=`${n.unit==="-"?`- ${n.name}`:n.unit} ${n.bySteps} ${n.along??""}`;t.set(s,[...t.get(s)??[],n])}for(let n of t.values())this.body.append(this.one(n));this.resize()}one(e){let t=e[0].unit==="-"?"":e[0].unit,{bySteps:n,along:s}=e[0],r=Q("figure.chart",{}),o=getComputedStyle(document.documentElement),a=o.getPropertyValue("--ink2").trim(),l=o.getPropertyValue("--line").trim(),c=o.getPropertyValue("--accent").trim(),h=[...new Set(e.map(x=>x.name))],u=e.every(x=>/unbalanced/.test(x.name)),f=(x,m)=>m.map(g=>g===null?"":kt(g)),d={width:300,height:180,title:(s?`${s}`:"")+(h.length===1?h[0]+(t?` [${t}]`:""):t?`[${t}]`:""),cursor:{sync:{key:s===void 0?"riprap":"riprap line"},drag:{x:!0,y:!1}},legend:{live:!0},scales:{x:{time:!1},y:u?{distr:3}:{}},axes:[{stroke:a,grid:{stroke:l,width:1},ticks:{stroke:l,width:1},size:28,values:f},{stroke:a,grid:{stroke:l,width:1},ticks:{stroke:l,width:1},size:62,values:f}],series:[{label:s!==void 0?"distance [m]":n?"step":"time [s]",value:(x,m)=>m===null?"\u2013":kt(m)},...e.map((x,m)=>({label:x.dash?`${x.name} (2)`:x.name,stroke:af[h.indexOf(x.name)%af.length]??af[m%af.length],width:1.4,...x.dash?{dash:[6,4]}:{},points:{show:x.x.length<40&&s===void 0,size:4},spanGaps:s===void 0,value:(g,b)=>b==null?"\u2013":kt(b)}))],hooks:{draw:[x=>{if(s!==void 0)return;let m=x.valToPos((n?this.now?.step:this.now?.time)??0,"x",!0),{left:g,top:b,width:M,height:y}=x.bbox;m<g||m>g+M||(x.ctx.save(),x.ctx.strokeStyle=c,x.ctx.setLineDash([]),x.ctx.lineWidth=1.5*devicePixelRatio,x.ctx.beginPath(),x.ctx.moveTo(m,b),x.ctx.lineTo(m,b+y),x.ctx.stroke(),x.ctx.restore())}]}},p=new zn(d,WR(e,u),r);return p.over.addEventListener("click",()=>{let{left:x}=p.cursor;s===void 0&&x!==void 0&&x!==null&&x>=0&&this.seek(p.posToVal(x,"x"),n)}),this.plots.push(p),r}resize(){let e=this.plots.length;if(e===0)return;let t=this.body.clientWidth,n=Math.max(1,Math.min(e,Math.floor(t/300))),s=Math.floor((t-24)/n)-12,r=e>n?190:Math.max(150,this.body.clientHeight-66);for(let o of this.plots)o.setSize({width:s,height:Math.min(r,320)})}retheme(){this.curves.length>0&&this.draw("")}};function BR({run:i,field:e,unit:t,parts:n},s,r){let o=[],a=[];n.forEach(({from:c,to:h,value:u},f)=>{f>0&&c>n[f-1].to*(1+1e-9)&&(o.push(.5*(n[f-1].to+c)),a.push(null)),o.push(c,h),a.push(u,u)});let l=r.length>1?`${i.summary.name}: `:"";return{name:e,unit:t,x:o,bySteps:!1,values:a,dash:!1,along:l}}function vy(i){return/[",\n]/.test(i)?`"${i.replaceAll('"','""')}"`:i}function zR(i){let{field:e,unit:t}=i[0],n=i.length>1,s=[...n?["run"]:[],"from [m]","to [m]","block","name",t==="-"?e:`${e} [${t}]`],r=i.flatMap(({run:o,parts:a})=>a.map(l=>[...n?[vy(o.summary.name)]:[],l.from,l.to,l.block,vy(o.called(l.block)),l.value].join(",")));return[s.join(","),...r,""].join(`
`)}function HR(i){return`${i[0].run.summary.name.replace(/\.run$/,"")}_${i[0].field}_line.csv`}function VR(i,e){return i.names.map((t,n)=>({name:t,unit:i.units[n],x:i.x,bySteps:i.bySteps,values:i.columns[n],dash:e}))}function da(i){return i.summary.names??GR(i.summary.fields??[])}function GR(i){return i.flatMap(e=>e.components===1?[e.name]:[e.name,...["x","y","z"].slice(0,e.components).map(t=>`${e.name}.${t}`)])}function WR(i,e){let t=i.map(s=>{let r=Array.from(s.x),o=Array.from(s.values,a=>a===null||!Number.isFinite(a)||e&&a<=0?null:a);return[r,o]}),n=i[0].x;return i.every(s=>s.x===n)?[t[0][0],...t.map(s=>s[1])]:zn.join(t)}var cf=class{constructor(e,t,n,s,r){this.runs=e;this.choices=t;this.actions=n;this.saved=s;this.dimension=r;this.object=Q("aside.panel",{"aria-label":"settings"}),this.rebuild(),t.listen(o=>{let a=["clipAt","clipDip","clipDirection","vectorSize"];(!this.object.querySelector("input[type=range]:active, input[type=range]:focus")||!o.every(c=>a.includes(c)))&&this.refill()})}runs;choices;actions;saved;dimension;object;blockBox=Q("div.numbers");status=Q("div.exportstate",{role:"status"});colourBox=Q("div");moveBox=Q("div");marksBox=Q("div");rebuild(e=this.dimension){this.dimension=e;let t=this.runs.filter(n=>n.summary.manifest?.preview&&n.summary.manifest.warnings.length>0);this.object.replaceChildren(...t.map(n=>Ar(`Warnings (${n.summary.manifest.warnings.length})`,!0,...this.warnings(n))),Ar("Colour",!0,this.colourBox),Ar("Shape and view",!0,this.moveBox),Ar("Vectors and contacts",!0,this.marksBox),Ar("Block",!0,this.blockBox),Ar("Views",!1,this.saved.object),Ar("Save",!1,this.saveBox()),...this.runs.map((n,s)=>Ar(this.runs.length>1?`Run ${s+1}`:"Run",!1,XR(n,this.warnings(n))))),this.refill(),this.blockBox.hasChildNodes()||this.showBlock(null)}warnings(e){return(e.summary.manifest?.warnings??[]).map(t=>{let n=zu(t,e.names);if(n.length===0)return Q("p.warning",{},t);let s=n.length===1?"Go to this block":`Go to these ${n.length} blocks`;return Q("button.warning",{type:"button",title:s,onclick:()=>this.actions.goTo(e,n)},t)})}refill(){this.colourBox.replaceChildren(...this.colourRows()),this.moveBox.replaceChildren(...this.moveRows()),this.marksBox.replaceChildren(...this.markRows())}colourRows(){let{choices:e}=this,t=e.now,n=[...new Set(this.runs.flatMap(l=>da(l)))],s=hi([["","one colour"],...n.map(l=>[l,l])],t.field,l=>e.set(hf(t,l)),"field"),r=ym(this.runs).map(l=>{let c=()=>e.set(hf(t,l));return Q("button",{type:"button",title:"Colour by this field (q: the next)","aria-pressed":String(l===t.field),onclick:c},l||"one colour")}),o=[Vn("Field",s)];r.length>1&&o.push(Q("div.buttons",{},...r));let a=this.meaning(t.field);if(a&&o.push(Q("p.hint",{},a)),!t.field||Mr.has(t.field))return o;if(o.push(Vn("Colours",hi(Object.keys(yp).map(l=>[l,l]),t.map,l=>e.set({map:l}),"colour map")),Vn("Range",hi([["most","run, 98 % of blocks"],["run","whole run"],["frame","this frame"],["fixed","fixed"]],t.rangeMode,l=>{let[c,h]=this.actions.range();e.set({rangeMode:l,low:c,high:h})},"range of the colours"))),t.rangeMode==="fixed"){let l=(c,h)=>{let u=Q("input",{type:"number",step:"any",value:String(t[c]),"aria-label":h});return u.addEventListener("change",()=>{Number.isFinite(u.valueAsNumber)&&e.set({[c]:u.valueAsNumber})}),u};o.push(Vn("From, to (SI)",l("low","lowest value"),l("high","highest value")))}return o.push(Q("div.checks",{},Gn("powers of ten",t.log,l=>e.set(l&&t.map==="blue-red"?{log:l,map:"light"}:{log:l}),"Logarithmic colours"),Gn("only in range",t.only,l=>e.set({only:l}),"Hide blocks whose value is outside the range"))),o}kindOf(e,t){if(t===void 0)return"";let n=this.runs.filter(s=>s.summary.manifest).map(s=>Fp(s,e,t));return n.every(s=>s===n[0])?n[0]??"":""}meaning(e){let t=e.replace(/\.(x|y|z|magnitude)$/,"");for(let n of this.runs){let s=n.summary.manifest?.fields?.find(r=>r.name===t||r.name===`block.${t}`);if(s)return s.meaning}return""}moveRows(){let{choices:e,actions:t}=this,n=e.now,s=Q("input",{type:"range",min:"0",max:"4",step:"0.02",value:String(Math.log10(Math.max(1,n.exaggeration))),"aria-label":"exaggeration"}),r=Q("output",{},`\xD7 ${kt(n.exaggeration,3)}`),o=()=>Number((10**Number(s.value)).toPrecision(2));s.addEventListener("input",()=>r.textContent=`\xD7 ${kt(o(),3)}`),s.addEventListener("change",()=>e.set({exaggeration:o()}));let a=(c,h,u)=>Q("button",{type:"button",title:h,onclick:u},c);return[Vn("Displacement",s,r),Q("div.buttons",{},a("true","Displacements as they are",()=>e.set({exaggeration:1})),a("visible","Exaggerate so that the largest displacement can be seen",()=>e.set({exaggeration:t.niceExaggeration()})),a("fit","All in view (f)",()=>t.fit()),...this.dimension===3?["x","y","z"].map(c=>a(c,`Look along ${c}`,()=>t.fit(c))):[],a("line","Distance, and the field along a line: click both ends; again: remove it (d)",t.line)),Q("div.checks",{},Gn("edges",n.edges,c=>e.set({edges:c}),"Draw the edges of the blocks (e)"),this.dimension===3?Gn("shadows",n.shadows,c=>e.set({shadows:c}),"Shadows of the sun, and darker hollows (y)"):null,this.runs.some(c=>c.hasField("held"))?Gn("supports",n.supports,c=>e.set({supports:c}),"Outline the blocks that supports hold or move (u)"):null,...this.conditionChecks()),...(n.shadows||n.edges)&&t.unshaded()?[Q("p.hint",{},t.unshaded())]:[],Vn("Joints",hi([["","not shown"],["set","by set (direction)"],...this.runs.some(c=>c.conditions)?[["interface","by interface"]]:[]],n.joints,c=>e.set({joints:c}),"joints")),...this.cutRows()]}conditionChecks(){let{choices:e}=this,t=e.now,n=this.runs.flatMap(r=>r.conditions??[]),s=[];return n.some(r=>r.faces.length>0)&&s.push(Gn("boundaries",t.boundaries,r=>e.set({boundaries:r}),"Colour the faces that are held, moved, viscous or loaded (h)")),n.some(r=>r.loads.length>0||r.faces.some(o=>o.kind==="loaded"))&&s.push(Gn("loads",t.loads,r=>e.set({loads:r}),"Arrows of given forces and pressures, at their full size (l)")),n.some(r=>r.water.length>0)&&s.push(Gn("water table",t.water,r=>e.set({water:r}),"The water table of the phase (w)")),s}cutRows(){let{choices:e}=this,t=e.now,n=this.dimension===3?["x","y","z"]:["x","y"],s=hi([["","nothing"],...n.map(l=>[l,`along ${l}`]),["free",this.dimension===3?"any plane":"any line"]],t.clipAxis,l=>e.set({clipAxis:l}),"clipping plane"),r=[Vn("Cut away",s)];if(!t.clipAxis)return r;let o=(l,c,h,u)=>{let f=Q("input",{type:"range",min:"0",max:String(c),step:String(h),value:String(t[l]),"aria-label":u}),d=l==="clipAt"?null:Q("output",{},`${t[l]}\xB0`);return f.addEventListener("input",()=>{d&&(d.textContent=`${f.value}\xB0`),e.set({[l]:Number(f.value)})}),[f,d]},a=hi([["flat","flat, through blocks"],["whole","whole blocks"]],t.clipFlat?"flat":"whole",l=>e.set({clipFlat:l==="flat"}),"kind of cut");return a.title="Flat, or whole blocks (b)",r.push(Vn("Cut is",a),Vn("Plane at",...o("clipAt",1,.002,"place of the cut"))),t.clipAxis==="free"&&(this.dimension===2?r.push(Vn("Angle from x",...o("clipDip",180,1,"angle of the cut"))):r.push(Vn("Dip",...o("clipDip",90,1,"dip of the cut")),Vn("Dip direction",...o("clipDirection",360,1,"dip direction of the cut")))),r.push(Q("div.checks",{},Gn("flip",t.clipFlip,l=>e.set({clipFlip:l}),"Remove the other side (o)"))),r}markRows(){let{choices:e}=this,t=e.now,n=new Set(this.runs.flatMap(p=>(p.summary.fields??[]).filter(x=>x.components>1).map(x=>x.name))),s=["displacement","velocity","force"].filter(p=>n.has(p)),r=this.runs.map(p=>p.summary.held).filter(p=>p!==void 0),o=s.filter(p=>r.every(x=>x.vectors.includes(p))),a=r.every(p=>p.contacts),c=s.length>o.length||!a?[Q("p.hint",{},"This report holds only part of the arrows and contacts; riprap view shows all.")]:[],h=this.runs.some(p=>p.hasStress);if(o.length===0&&!a&&!h)return c;let u=this.runs.some(p=>p.conditions?.water.some(x=>x.seeps)),f=a?["contact force",...u?["seepage flow"]:[]]:[],d=[Vn("Arrows",hi([["","none"],...[...o,...f].map(p=>[p,p])],t.vectors,p=>e.set({vectors:p}),"vectors"))];if(h&&d.push(Q("div.checks",{},Gn("stress",t.stress,p=>e.set({stress:p}),"Principal stresses as crosses: blue in compression, red in tension (a)"))),t.vectors||t.stress||t.chains){let p=Q("input",{type:"range",min:"-1",max:"1",step:"0.05",value:String(Math.log10(t.vectorSize)),"aria-label":"size of arrows, crosses and chains"});p.addEventListener("input",()=>e.set({vectorSize:10**Number(p.value)})),d.push(Vn("Size",p))}if(!a)return[...d,...c];if(d.push(Q("div.checks",{},Gn("contacts",t.contacts,p=>e.set({contacts:p}),"Points at contacts, coloured by state (c)"),Gn("force chains",t.chains,p=>e.set({chains:p}),"Tubes from block to block, as thick and dark as the contact force (n)"),this.dimension===3?Gn("cracks",t.cracks,p=>e.set({cracks:p}),"Broken and open faces between glassy blocks (k)"):null,this.runs.some(p=>p.summary.bolts)?Gn("bolts",t.bolts,p=>e.set({bolts:p}),"Bars of bolts, red in tension, blue in compression (r)"):null,this.runs.some(p=>(p.summary.manifest?.sources??[]).length>0)?Gn("charges",t.charges,p=>e.set({charges:p}),"Stars where charges are (i)"):null)),t.contacts){let p=this.actions.states();d.push(Q("div.checks",{},...Qs.flatMap((x,m)=>{if(m>1&&!p[m])return[];let g=Gn(x.name,t.states[m],b=>e.set({states:t.states.map((M,y)=>y===m?b:M)}));return g.style.setProperty("--chip",x.colour),g.classList.add("chipped"),g})))}return[...d,...c]}saveBox(){let e=(t,n,s)=>Q("button",{type:"button",title:n,onclick:s},t);return Q("div",{},Q("div.buttons",{},e("Picture","PNG of what is shown (s)",this.actions.picture),e("All frames","PNG of every frame, in a zip",this.actions.sequence),e("Film","WebM with every frame once, at the frames per second of the bar below",this.actions.film)),this.saved.pathRow(this.dimension),this.status)}say(e){this.status.textContent=e}showBlock(e,t=""){if(!e){this.blockBox.replaceChildren(Q("p.hint",{},t||"Click a block to see its numbers and their history."));return}let n=e.columns.filter(r=>r.name!=="block").map(r=>{let o=r.values.map(h=>typeof h=="number"?h:Number.NaN),a=o.length>1?`${un(Math.hypot(...o),r.unit)}`:r.unit==="-"?kt(o[0]??Number.NaN):un(o[0]??Number.NaN,r.unit),l=Mr.has(r.name)?this.kindOf(r.name,o[0]):"",c=o.length>1?`(${o.map(h=>kt(h,3)).join(", ")})`:"";return Q("tr",{},Q("td",{},r.name),Q("td",{},l||a,c?Q("small",{},c):null))}),s=e.groups.length?[yy(e.groups.length>1?"groups":"group",e.groups.join(", "))]:[];this.blockBox.replaceChildren(Q("div.buttons.pickhead",{},Q("b",{},e.name||`block ${e.block}`),Q("button",{type:"button",onclick:this.actions.history},"history"),Q("button",{type:"button",onclick:this.actions.unpick,title:"Deselect (Esc)"},"clear")),Q("table",{},...e.name?[yy("number",String(e.block))]:[],...s,...n))}};function ym(i){let e=new Set(i.flatMap(t=>da(t)));return[e.has("material")?"material":"",...["displacement","velocity"].filter(t=>e.has(t))]}function hf(i,e){return{field:e,map:mu(e),log:!1,rangeMode:i.rangeMode==="fixed"?"most":i.rangeMode}}function yy(i,e){return Q("tr",{},Q("td",{},i),Q("td",{},e))}function Ar(i,e,...t){return Q("details",{open:e},Q("summary",{},i),...t)}function XR(i,e){let{manifest:t,name:n}=i.summary;if(!t)return Q("p.hint",{},"This folder cannot be read.");let s=[["folder",n],["scene",t.scenario],["case",[t.variant,t.case].filter((a,l,c)=>a&&a!=="default"&&c.indexOf(a)===l).join(", ")],["ended",t.ended+(t.message?`: ${t.message}`:"")],["model time",un(t.time,"s")],["steps",t.steps.toLocaleString("en")],["time step",un(t.dt,"s")],["wall time",`${kt(t.wall_time,3)} s on ${t.threads} thread${t.threads===1?"":"s"}`],["started",t.started.replace("T"," ").replace("Z"," UTC")],["riprap",t.riprap],["state hash",t.state_hash.slice(0,16)]],o=["scenario.resolved.toml","manifest.json","histories.csv","energy.csv","events.jsonl"].flatMap(a=>{let l=i.source.file(a);return l?[Q("a",{href:l,target:"_blank",rel:"noopener"},a)," "]:[]});return Q("div",{},Q("table",{},...s.filter(([,a])=>a).map(([a,l])=>Q("tr",{},Q("td",{},a),Q("td",{},l)))),...t.preview?[]:e,Q("p.files",{},...o))}var Vl={field:"material",map:"light",rangeMode:"most",low:0,high:1,log:!1,exaggeration:1,edges:!0,shadows:!0,supports:!1,boundaries:!1,loads:!1,water:!0,joints:"",clipAxis:"",clipAt:.5,clipFlip:!1,clipFlat:!0,clipDip:60,clipDirection:240,only:!1,vectors:"",vectorSize:1,stress:!1,contacts:!1,states:[!1,!0,!0,!0,!0,!0,!0,!0],cracks:!1,bolts:!0,chains:!1,charges:!0,speed:10,loop:!0},uf=class{now={...Vl,states:[...Vl.states]};listeners=[];set(e){Object.assign(this.now,e);for(let t of this.listeners)t(Object.keys(e))}listen(e){this.listeners.push(e)}};var _m=i=>i.toArray();function qR(i,e,t){let{stage:n,scale:s}=i,r=new N(...i.blocks.shape.info.origin),{position:o,target:a,zoom:l}=n.standpoint(),c=e.field!==""&&!Mr.has(e.field),h=Object.entries(e).filter(([u,f])=>JSON.stringify(f)!==JSON.stringify(Vl[u]));return{name:t,eye:_m(o.add(r)),target:_m(a.add(r)),up:_m(n.camera.up),angle:n.camera instanceof pn?n.camera.fov:null,zoom:l,field:e.field,log:e.log,range:c?[s.low,s.high]:null,exaggeration:e.exaggeration,cut:i.cutAway(e),bolts:e.bolts,settings:Object.fromEntries(h)}}function wy(i,e){let t=new N(...i.blocks.shape.info.origin);return{position:new N(...e.eye).sub(t),target:new N(...e.target).sub(t),zoom:e.zoom}}function $R(i,e,t){if(e==="views"&&t.length>1){let n=t.map(l=>wy(i,l)),s=new Hr(n.map(l=>l.position)),r=n.map(l=>l.target),a=r.every(l=>l.distanceTo(r[0])<1e-9)?null:new Hr(r);return l=>{let c=l*(n.length-1),h=Math.min(n.length-2,Math.floor(c)),u=Jn.lerp(n[h].zoom,n[h+1].zoom,c-h);return{position:s.getPoint(l),target:a?.getPoint(l)??r[0].clone(),zoom:u}}}if(e==="round"&&!i.flat){let{position:n,target:s,zoom:r}=i.stage.standpoint(),o=i.stage.camera.up.clone().normalize();return a=>({position:n.clone().sub(s).applyAxisAngle(o,2*Math.PI*a).add(s),target:s.clone(),zoom:r})}return null}function _y(i){return Array.isArray(i)&&i.length===3&&i.every(e=>Number.isFinite(e))}function My(i){let e=n=>new Qn(`views.json: ${n}.`,"Save the file again from the viewer."),t;try{t=JSON.parse(i).views}catch(n){throw e(String(n))}if(!Array.isArray(t))throw e("it has no list `views`");return t.map((n,s)=>{let{name:r,eye:o,target:a}=n;if(typeof r!="string"||!_y(o)||!_y(a))throw e(`view ${s+1} needs a name, an eye and a target`);return{...{up:[0,0,1],angle:32,zoom:1,field:"displacement",log:!1,range:null,exaggeration:1,cut:null,bolts:!0},...n,name:r,eye:o,target:a,settings:n.settings??{}}})}var ff=class{constructor(e,t){this.views=e;this.choices=t;let n=Q("input",{type:"text",placeholder:"name","aria-label":"name of the view",maxLength:60}),s=()=>{this.add(n.value.trim()||`view ${this.all.length+1}`),n.value=""};n.addEventListener("keydown",o=>{o.key==="Enter"&&s()});let r=(o,a,l)=>Q("button",{type:"button",title:a,onclick:l},o);this.object.append(Q("div.buttons",{},n,r("save view","Keep camera, colours and cut under this name",s),r("views.json","All saved views in a file: riprap shot RUN --views FILE --saved NAME draws them; in the run folder the viewer finds them again",()=>this.write())),this.list,this.said),this.fill()}views;choices;object=Q("div");path="";all=[];said=Q("p.hint",{role:"status"});list=Q("div.buttons");pathRow(e){let t=[["","stays"],["views","through the saved views"],...e===3?[["round","once around"]]:[]];return Vn("Camera",hi(t,this.path,n=>this.path=n,"camera of a film"))}move(){if(this.path==="views"&&this.all.length<2)throw new Error("Save two views or more: the camera goes through them in their order.");let e=this.views()[0];return e?.blocks?$R(e,this.path,this.all):null}async load(){let e=this.views()[0]?.run;if(e){try{let t=localStorage.getItem(this.key());t&&(this.all=My(t))}catch{}try{let t=e.summary.views?e.source.file("views.json"):void 0;if(t)for(let n of My(await(await fetch(t)).text()))this.put(n)}catch(t){this.said.textContent=t instanceof Qn?`${t.what} ${t.hint}`:String(t)}this.fill()}}key(){return`riprap.views.${this.views()[0]?.run.summary.name??""}`}put(e){let t=this.all.findIndex(n=>n.name===e.name);t<0?this.all.push(e):this.all[t]=e}add(e){let t=this.views()[0];t?.blocks&&(this.put(qR(t,this.choices.now,e)),this.kept())}kept(){this.fill();try{localStorage.setItem(this.key(),this.text())}catch{}}text(){return JSON.stringify({views:this.all},null,1)}write(){this.all.length===0?this.said.textContent="No views saved yet.":lr(new Blob([this.text()],{type:"application/json"}),"views.json")}fill(){this.list.replaceChildren(...this.all.map(e=>Q("span.saved",{},Q("button",{type:"button",title:"Go to this view",onclick:()=>this.go(e)},e.name),Q("button",{type:"button",title:`Remove ${e.name}`,"aria-label":`remove ${e.name}`,onclick:()=>this.remove(e)},"\xD7")))),this.said.textContent=""}remove(e){this.all=this.all.filter(t=>t!==e),this.kept()}go(e){let{states:t,...n}={...Vl,...e.settings,field:e.field};this.choices.set({...n,states:[...t]});for(let s of this.views())s.blocks&&s.stage.follow(wy(s,e))}};var df=class{constructor(e,t,n){this.choices=e;this.show=t;this.ahead=n;this.slider=Q("input.scrub",{type:"range",min:"0",max:"0",step:"1",value:"0","aria-label":"time"}),this.slider.addEventListener("input",()=>{this.pause(),this.following=!1,this.go(Number(this.slider.value))}),this.label=Q("output.time",{"aria-live":"off"}),this.playButton=Ui("play","Play (space)",()=>this.toggle()),this.playButton.classList.add("primary");let s=[1,2,5,10,20,30].map(o=>[String(o),`${o}/s`]),r=hi(s,String(e.now.speed),o=>e.set({speed:Number(o)}),"frames per second");r.title="Frames per second",this.object=Q("div.timeline",{},Ui("first","First frame (Home)",()=>{this.go(0)}),Ui("back","One frame back (\u2190)",()=>this.step(-1)),this.playButton,Ui("next","One frame forward (\u2192)",()=>this.step(1)),Ui("last","Last frame (End)",()=>{this.go(this.moments.length-1)}),this.slider,this.label,r)}choices;show;ahead;object;moments=[];at=0;playing=!1;following=!1;slider;label;playButton;busy=!1;wanted=null;setMoments(e){this.moments=e,this.slider.max=String(Math.max(0,e.length-1)),this.object.classList.toggle("empty",e.length===0),this.say()}say(){let e=this.moments[this.at],t=e?Dp(e):"";this.slider.value=String(this.at),this.label.replaceChildren(Q("b",{title:t},t||"no frames"),Q("small",{},this.moments.length?`${this.at+1} of ${this.moments.length}`:"")),this.slider.setAttribute("aria-valuetext",t)}async go(e){let t=this.moments.length-1;if(this.at=Math.min(Math.max(0,e),Math.max(0,t)),this.say(),!(t<0)){if(this.busy){this.wanted=this.at;return}this.busy=!0;try{await this.show(this.moments[this.at])}finally{this.busy=!1}if(this.wanted!==null){let n=this.wanted;this.wanted=null,n!==e&&await this.go(n)}}}async seek(e,t){let n=r=>Math.abs((t?r.step:r.time)-e),s=0;this.moments.forEach((r,o)=>{n(r)<n(this.moments[s])&&(s=o)}),this.following=!1,await this.go(s)}step(e){this.pause(),this.following=!1,this.go(this.at+e)}toggle(){this.playing?this.pause():this.play()}pause(){this.playing=!1,this.face()}face(){this.playButton.replaceChildren(Af(this.playing?"pause":"play"));let e=this.playing?"Pause (space)":"Play (space)";this.playButton.title=e,this.playButton.setAttribute("aria-label",e)}async play(){if(!(this.playing||this.moments.length<2)){for(this.playing=!0,this.following=!1,this.face(),this.at>=this.moments.length-1&&await this.go(0);this.playing;){let e=performance.now();if(this.at>=this.moments.length-1&&!this.choices.now.loop)break;let t=(this.at+1)%this.moments.length;for(let s of[1,2]){let r=this.moments[(t+s)%this.moments.length];r!==void 0&&this.ahead(r)}await this.go(t),await new Promise(s=>requestAnimationFrame(s));let n=1e3/this.choices.now.speed-(performance.now()-e);n>1&&await new Promise(s=>setTimeout(s,n))}this.pause()}}};var Ey="riprap-theme",Ty=window.matchMedia("(prefers-color-scheme: dark)"),pf=document.documentElement,YR=pf.dataset.theme;function ZR(){try{return localStorage.getItem(Ey)}catch{return null}}function Sy(){pf.dataset.theme=ZR()??YR??(Ty.matches?"dark":"light")}function mf(i=()=>{}){Sy(),Ty.addEventListener("change",()=>{Sy(),i()})}function Ay(){let i=pf.dataset.theme==="dark"?"light":"dark";pf.dataset.theme=i;try{localStorage.setItem(Ey,i)}catch{}}var JR=1e3,KR=["field","rangeMode","vectors","contacts","cracks","bolts","chains","stress","supports","joints"],gf=class{constructor(e,t){this.host=e;this.loading=t}host;loading;choices=new uf;runs=[];panes=[];silent=new Set;timeline;panel=null;plots=null;saved=new ff(()=>this.panes.map(({view:e})=>e),this.choices);stages=Q("div.stages");badge=Q("span.badge");title=Q("h1");measuring=!1;work=null;async start(e){this.runs=await Promise.all(e.map(o=>Du.open(o)));let t=this.runs.filter(o=>!o.summary.problem);await Promise.all(t.map(o=>o.readModel())),this.chooseField(t),this.timeline=new df(this.choices,o=>this.showMoment(o),o=>{for(let{view:a}of this.panes)a.prefetch(a.run.frameAt(o),this.choices.now)}),this.layout(t);for(let{view:o}of this.panes)o.others=t.filter(a=>a!==o.run);this.timeline.setMoments(this.moments(t)),this.refreshHead(),t.some(o=>o.summary.live)&&(this.timeline.following=!0,this.news());for(let{view:o}of this.panes)o.hasty=!0;await this.timeline.go(this.timeline.moments.length-1);for(let o of this.panes)this.refreshPane(o);let[n,...s]=this.panes;if(n)for(let o of s)o.view.stage.follow(n.view.stage.standpoint());let r=this.panes[0]?.view.flat??!0;this.panel?.rebuild(r?2:3),this.panel?.refill(),document.documentElement.dataset.shown="true";for(let{view:o}of this.panes)o.hasty=!1;await this.timeline.go(this.timeline.at),await this.saved.load(),document.documentElement.dataset.ready="true"}chooseField(e){let t=e.flatMap(n=>da(n));t.includes("removable_type")&&(this.choices.now.field="removable_type"),t.includes(this.choices.now.field)||(this.choices.now.field=""),this.choices.now.map=mu(this.choices.now.field)}moments(e){let t=(s,r)=>s.time-r.time||s.nth-r.nth,n=e.flatMap(s=>s.moments()).sort(t);return n.filter((s,r)=>r===0||t(s,n[r-1])>0)}layout(e){for(let l of this.runs)l.summary.problem?this.stages.append(QR(l.summary.name,l.summary.problem)):this.addPane(l);let t=e[0],n=t?.summary.fields.some(l=>l.components===3)?3:2;this.panel=new cf(this.runs,this.choices,this.actions(),this.saved,n),this.plots=new lf(e,(l,c)=>{this.timeline.seek(l,c)},()=>this.lines());let s=this.shortcuts(),r=qb(s);Xb(s,this.host);let o=l=>()=>{this.host.classList.toggle(l),l==="with-plots"&&this.openPlots()},a=Q("header",{},this.title,this.badge,Q("span.spacer"),Ui("camera","Save a picture (s)",()=>{this.save("picture")}),Ui("plots","Histories (p)",o("with-plots")),Ui("theme","Light or dark (t)",()=>this.flipTheme()),Ui("help","Keys and mouse (?)",()=>r.showModal()),Ui("menu","Panel (m)",o("no-panel")));this.host.replaceChildren(a,Q("main",{},Q("div.middle",{},this.stages,this.plots.object),this.panel.object),this.timeline.object,r,this.loading.object),window.innerWidth<760&&this.host.classList.add("no-panel"),this.choices.listen(l=>{this.changed(l)}),mf(()=>this.themed()),this.themed(),e.length>0&&t.summary.tables[0]&&window.innerHeight>820&&window.innerWidth>1100&&(this.host.classList.add("with-plots"),this.openPlots())}addPane(e){let t=Q("div.stage"),n={host:t,view:new Vu(e,t,this.loading),legend:Q("div.legendhost"),banner:Q("div.banner",{role:"alert",hidden:!0}),head:Q("div.panehead"),triad:Q("div.triad",{"aria-hidden":"true"})};t.append(n.head,n.legend,n.banner,n.triad),this.stages.append(t),this.panes.push(n);let{view:s}=n;s.stage.onMove=o=>{for(let a of this.panes)a!==n&&a.view.stage.follow(o)},s.stage.onDrawn=()=>tC(n);let r=null;s.stage.canvas.addEventListener("pointerdown",o=>r=[o.clientX,o.clientY]),s.stage.canvas.addEventListener("pointerup",o=>{r&&Math.hypot(o.clientX-r[0],o.clientY-r[1])<5&&o.button===0&&(this.measuring?this.measure(s,o.clientX,o.clientY):this.pick(n,s.pickAt(o.clientX,o.clientY))),r=null}),s.stage.canvas.addEventListener("webglcontextlost",o=>{o.preventDefault(),this.banner(n,{what:"The browser has lost its graphics context.",hint:"Reload the page."})}),e.frames===0&&this.banner(n,Mm(e))}measure(e,t,n){let s=e.placeAt(t,n);if(!s)return;let r=e.ends.length===1?[e.ends[0],s]:[s];this.layLine(r),!(r.length<2)&&(this.setMeasuring(!1),this.host.classList.add("with-plots"),this.plots?.open("line"))}layLine(e){for(let t of this.panes)t.view.lay(e),this.refreshPane(t);this.plots?.changed()}setMeasuring(e){this.measuring=e,this.host.classList.toggle("measuring",e)}lines(){let{field:e}=this.choices.now;return this.panes.flatMap(({view:t})=>{let{pieces:n,length:s}=t.along();if(!t.values||s===0)return[];let r=n.map(o=>({from:o.from*s,to:o.to*s,block:t.blocks.ids[o.block],value:t.values[o.block]}));return[{run:t.run,field:e,unit:t.unit,length:s,parts:r}]})}async showMoment(e){await Promise.all(this.panes.map(({view:n})=>n.show(n.run.frameAt(e),this.choices.now)));for(let n of this.panes)this.refreshPane(n);this.plots?.mark(e),this.plots?.changed();let t=this.panes.find(n=>n.view.picked!==null);t&&!this.timeline.playing&&await this.showNumbers(t)}refreshPane(e){let{view:t}=e;e.legend.replaceChildren(Bb(Gu(t,this.choices.now),t.scale)),t.run.frames>0&&this.banner(e,t.trouble??t.run.summary.note??eC(t.run)),e.host.classList.toggle("stale",t.trouble!==null);let{summary:n}=t.run;if(this.runs.length>1){let s=t.run.saidAt(t.frame);e.head.replaceChildren(Q("b",{},n.manifest.title||n.name),Q("span",{},` ${n.name}${s?` \xB7 ${s}`:""}`))}t.stage.canvas.dataset.frame=String(t.frame),t.stage.canvas.dataset.faces=String(t.blocks?.visibleFaces??0),t.stage.canvas.dataset.blocks=String(t.blocks?.count??0),t.stage.canvas.dataset.cut=String(t.blocks?.cutBlocks??0)}banner(e,t){e.banner.hidden=t===null,t&&e.banner.replaceChildren(Q("b",{},t.what),Q("span",{},t.hint))}async changed(e){let t=this.choices.now;if(e.some(n=>KR.includes(n))){let n=this.timeline.moments[this.timeline.at];await Promise.all(this.panes.map(({view:s})=>s.show(n?s.run.frameAt(n):Math.max(0,s.frame),t))),(e.includes("contacts")||e.includes("chains"))&&this.panel?.refill()}else for(let{view:n}of this.panes)n.apply(t,e.includes("exaggeration"));for(let n of this.panes)this.refreshPane(n);this.plots?.changed()}async pick(e,t){for(let n of this.panes)n.view.pick(n===e?t:null);this.plots?.setPicked(e.view.run,t),t===null?this.panel?.showBlock(null):await this.showNumbers(e)}async showNumbers(e){let{view:t}=e;if(t.picked!==null)try{this.panel?.showBlock(await t.run.block(t.frame,t.picked))}catch(n){let{what:s,hint:r}=Sr(n);this.panel?.showBlock(null,`${s.replace(/\.$/,"")}. ${r}`)}}openPlots(){this.host.classList.contains("with-plots")&&this.plots?.open(this.plots.tab)}actions(){let e=()=>this.panes[0]?.view;return{fit:t=>{let n=e();if(n?.fit(t),n)for(let s of this.panes.slice(1))s.view.stage.follow(n.stage.standpoint())},picture:()=>{this.save("picture")},sequence:()=>{this.save("sequence")},film:()=>{this.save("film")},niceExaggeration:()=>Math.min(...this.panes.map(({view:t})=>t.niceExaggeration())),unpick:()=>{for(let t of this.panes)this.pick(t,null)},goTo:(t,n)=>{let s=this.panes.find(r=>r.view.run===t);if(s){s.view.goTo(n);for(let r of this.panes)r!==s&&r.view.stage.follow(s.view.stage.standpoint());this.pick(s,n[0]??null)}},line:()=>this.toggleLine(),history:()=>{this.host.classList.add("with-plots"),this.plots?.open("block")},range:()=>{let t=e()?.scale;return t?[t.low,t.high]:[0,1]},unshaded:()=>this.panes.map(({view:t})=>t.unshaded).find(t=>t!=="")??"",states:()=>Qs.map((t,n)=>this.panes.some(({view:s})=>(s.between?.counts[n]??0)>0))}}async save(e){let t=this.panes.filter(r=>r.view.blocks).map(r=>r.view);if(t.length===0)return;if(this.work){this.work.abort();return}let n=new AbortController;this.work=n;let s=r=>(this.panel?.say(`${Math.round(100*r)} %; choose it again to stop`),!n.signal.aborted);try{e==="picture"?await Hp(t,this.choices.now):await Vp[e]([t,this.choices.now,this.timeline,this.saved.move()],s),this.panel?.say(n.signal.aborted?"stopped":"saved")}catch(r){this.panel?.say(Sr(r).what)}finally{this.work=null}}shortcuts(){let{choices:e,timeline:t}=this,n=this.actions(),s=c=>()=>e.set({exaggeration:Math.min(1e4,Math.max(1,Number((e.now.exaggeration*c).toPrecision(2))))}),r=()=>{let h=["","x","y","z","free"].filter(u=>u!=="z"||this.panes.some(({view:f})=>!f.flat));e.set({clipAxis:h[(h.indexOf(e.now.clipAxis)+1)%h.length]})},o=()=>{let c=ym(this.runs),h=c[(c.indexOf(e.now.field)+1)%c.length];h!==void 0&&e.set(hf(e.now,h))},a=()=>{let c=["","set","interface"];e.set({joints:c[(c.indexOf(e.now.joints)+1)%c.length]})},l=c=>h=>e.set({clipAt:Math.min(1,Math.max(0,Number((e.now.clipAt+(h?10:1)*c).toFixed(4))))});return[{keys:[" "],label:"space",what:"play, pause",act:()=>t.toggle()},{keys:["ArrowLeft"],label:"\u2190",what:"one frame back (shift: ten)",act:c=>t.step(c?-10:-1)},{keys:["ArrowRight"],label:"\u2192",what:"one frame forward (shift: ten)",act:c=>t.step(c?10:1)},{keys:["Home"],label:"Home",what:"first frame",act:()=>{t.go(0)}},{keys:["End"],label:"End",what:"last frame",act:()=>{t.go(t.moments.length-1)}},{keys:["g"],label:"g",what:"follow a run in progress",act:()=>this.follow()},{keys:["f"],label:"f",what:"all in view",act:()=>n.fit()},...["x","y","z"].map((c,h)=>({keys:[String(h+1)],label:String(h+1),what:`look along ${c} (in space)`,act:()=>n.fit(c)})),{keys:["e"],label:"e",what:"edges",act:()=>e.set({edges:!e.now.edges})},{keys:["y"],label:"y",what:"light and shadow (in space)",act:()=>e.set({shadows:!e.now.shadows})},{keys:["q"],label:"q",what:"colours: materials, displacement, velocity",act:o},{keys:["u"],label:"u",what:"supports",act:()=>e.set({supports:!e.now.supports})},{keys:["h"],label:"h",what:"boundaries: held, moved, viscous, loaded faces (in space)",act:()=>e.set({boundaries:!e.now.boundaries})},{keys:["l"],label:"l",what:"loads: arrows",act:()=>e.set({loads:!e.now.loads})},{keys:["w"],label:"w",what:"water table",act:()=>e.set({water:!e.now.water})},{keys:["j"],label:"j",what:"joints: by set, by interface, not",act:a},{keys:["c"],label:"c",what:"contacts",act:()=>e.set({contacts:!e.now.contacts})},{keys:["n"],label:"n",what:"force chains: tubes as thick as the contact force",act:()=>e.set({chains:!e.now.chains})},{keys:["k"],label:"k",what:"cracks (in space)",act:()=>e.set({cracks:!e.now.cracks})},{keys:["r"],label:"r",what:"bolts: rods, red in tension, blue in compression",act:()=>e.set({bolts:!e.now.bolts})},{keys:["i"],label:"i",what:"charges: stars where they are (in space)",act:()=>e.set({charges:!e.now.charges})},{keys:["a"],label:"a",what:"principal stresses as crosses",act:()=>e.set({stress:!e.now.stress})},{keys:["d"],label:"d",what:"distance, and the field along a line: click both ends (again: remove it)",act:()=>this.toggleLine()},{keys:["v"],label:"v",what:"velocity arrows",act:()=>e.set({vectors:e.now.vectors?"":"velocity"})},{keys:["x"],label:"x",what:"cut away: along x, y, z, any plane, nothing",act:r},{keys:["b"],label:"b",what:"cut flat, or whole blocks",act:()=>e.set({clipFlat:!e.now.clipFlat})},{keys:["o"],label:"o",what:"cut away the other side",act:()=>e.set({clipFlip:!e.now.clipFlip})},{keys:[",",";","<"],label:",",what:"cut back (shift: ten times as far)",act:l(-.01)},{keys:[".",":",">"],label:".",what:"cut forward (shift: ten times as far)",act:l(.01)},{keys:["["],label:"[",what:"less exaggeration",act:s(.5)},{keys:["]"],label:"]",what:"more exaggeration",act:s(2)},{keys:["p"],label:"p",what:"histories",act:()=>this.toggle("with-plots")},{keys:["m"],label:"m",what:"panel",act:()=>this.toggle("no-panel")},{keys:["s"],label:"s",what:"save a picture",act:()=>{this.save("picture")}},{keys:["t"],label:"t",what:"light, dark",act:()=>this.flipTheme()},{keys:["Escape"],label:"Esc",what:"deselect the block",act:()=>n.unpick()},{keys:["?"],label:"?",what:"this sheet",act:()=>document.querySelector("dialog.sheet")?.showModal()}]}toggleLine(){let e=this.measuring||this.panes.some(({view:t})=>t.ends.length>0);this.layLine([]),this.setMeasuring(!e)}toggle(e){this.host.classList.toggle(e),this.openPlots()}follow(){this.timeline.following=!this.timeline.following,this.refreshHead(),this.timeline.following&&this.timeline.go(this.timeline.moments.length-1)}news(){setTimeout(async()=>{let e=this.panes.map(r=>r.view.run),t=await Promise.allSettled(e.map(r=>r.refresh()));if(t.some(r=>r.status==="fulfilled"&&r.value)){location.reload();return}let n=this.moments(e),s=n.length!==this.timeline.moments.length;this.timeline.setMoments(n),this.refreshHead();for(let r of this.panes)r.view.run.summary.manifest?.preview&&this.refreshPane(r);if(s){if(this.timeline.following)await this.timeline.go(n.length-1);else for(let r of this.panes)this.refreshPane(r);for(let r of this.panes)r.view.run.frames===0&&this.banner(r,Mm(r.view.run))}s&&this.plots&&this.plots.tab!=="block"&&this.openPlots(),this.panes.forEach((r,o)=>this.answered(r,t[o])),e.some(r=>r.summary.live)?this.news():this.panel?.rebuild()},JR)}answered(e,t){t.status==="rejected"?(this.silent.add(e),this.banner(e,Sr(t.reason))):this.silent.delete(e)&&(e.view.run.frames===0?this.banner(e,Mm(e.view.run)):this.refreshPane(e))}refreshHead(){let e=this.runs[0],{manifest:t,name:n}=e.summary,s=this.runs.map(l=>l.summary.manifest?.title||l.summary.name);this.title.textContent=[...new Set(s)].join(" | "),this.title.title=n,document.title=`${s[0]} \u2013 riprap`;let r=this.runs.some(l=>l.summary.live),o=this.runs.some(l=>l.summary.died),a=t?t.preview?"not run":r?"running":o?"unfinished":t.ended:"unreadable";this.badge.textContent=r&&this.timeline.following&&!t?.preview?"running, followed":a,this.badge.className=`badge ${a}`,this.badge.title=t?r?`step ${t.steps.toLocaleString("en")}; g follows the newest frame`:o?"The program that wrote this run has died. Its results so far are shown; riprap resume continues from the last checkpoint.":`${t.message||"all phases are complete"}; ${kt(t.wall_time,3)} s`:""}flipTheme(){Ay(),this.themed()}themed(){let e=getComputedStyle(document.documentElement),t=e.getPropertyValue("--paper").trim(),n=e.getPropertyValue("--ink").trim();for(let{view:s}of this.panes)s.setTheme(t,n);this.plots?.retheme()}};function QR(i,e){return Q("div.cardhost",{},Q("div.card.problem",{role:"alert"},Q("h2",{},`${i} cannot be shown`),Q("p",{},e.what),Q("p.hint",{},e.hint)))}function eC(i){let{preview:e,message:t}=i.summary.manifest??{};return e&&t?{what:"The scene as saved cannot be shown.",hint:t}:null}function Mm(i){return i.summary.live?{what:"No frame yet.",hint:"The run has started; the first frame will be shown when it is written."}:{what:"This run has no frames.",hint:'Request them in the scene and run it again: [[outputs]] frames = { every = "10 ms" }. Its histories are available (p).'}}function tC(i){let{view:e}=i;if(!e.blocks)return;let t=e.stage.triad(),n=e.flat?["x","y"]:["x","y","z"],s=["#d9483b","#2f9e57","#3576d6"],r=n.map((h,u)=>{let[f,d]=[32+24*t[u][0],32-24*t[u][1]],[p,x]=[32+30*t[u][0],32-30*t[u][1]];return`<line x1="32" y1="32" x2="${f}" y2="${d}" stroke="${s[u]}"/><text x="${p}" y="${x}" fill="${s[u]}">${h}</text>`}),o=e.stage.metresPerPixel(),a=90*o,l=10**Math.floor(Math.log10(a)),c=([5,2,1].find(h=>h*l<=a)??1)*l;i.triad.innerHTML=`<svg viewBox="0 0 64 64" width="64" height="64">${r.join("")}</svg><span class="bar" style="width:${(c/o).toFixed(1)}px">${un(c,"m",3)}</span>`}async function nC(){let i=document.getElementById("riprap-run");if(i?.textContent)return[new Lu(new Map(Object.entries(JSON.parse(i.textContent))))];let e=await fetch("api/runs"),{runs:t}=await e.json();return Array.from({length:t},(n,s)=>new Iu(s,Sm))}mf();var wm=document.getElementById("app")??Q("div"),Sm=new Pu;wm.append(Sm.object);try{await new gf(wm,Sm).start(await nC())}catch(i){let{what:e,hint:t}=Sr(i);wm.replaceChildren(Q("div.card.problem",{role:"alert"},Q("h1",{},"The viewer cannot start"),Q("p",{},e),Q("p.hint",{},t)))}
