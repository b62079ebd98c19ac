var N_=Object.defineProperty;var U_=(i,e)=>{for(var t in e)N_(i,t,{get:e[t],enumerable:!0})};function Z(i,e={},...t){let[n,...s]=i.split("."),r=document.createElement(n);s.length>0&&(r.className=s.join(" "));for(let[o,a]of Object.entries(e))o.startsWith("on")&&typeof a=="function"?r.addEventListener(o.slice(2),a):o in r&&!o.startsWith("aria")&&o!=="for"?r[o]=a:a!==void 0&&a!==!1&&r.setAttribute(o,String(a));return r.append(...t.filter(o=>o!=null)),r}function Rn(i,...e){return Z("label.row",{},Z("span.name",{},i),Z("span.controls",{},...e))}function Xn(i,e,t,n=""){let s=Z("input",{type:"checkbox",checked:e,onchange:()=>t(s.checked)});return Z("label.check",{title:n},s,Z("span",{},i))}function Qn(i,e,t,n){let s=Z("select",{onchange:()=>t(s.value),"aria-label":n});for(let[r,o]of i)s.append(Z("option",{value:r},o));return s.value=e,s}function yr(i,e){let t=URL.createObjectURL(i),n=Z("a",{href:t,download:e});document.body.append(n),n.click(),n.remove(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}var F_={play:"M7 4l13 8-13 8z",pause:"M6 4h4v16H6zM14 4h4v16h-4z",first:"M6 5h2v14H6zM20 5v14L9 12z",last:"M16 5h2v14h-2zM4 5v14l11-7z",back:"M17 5v14L7 12z",next:"M7 5v14l10-7z",fit:"M4 9V4h5v2H6v3zM15 4h5v5h-2V6h-3zM4 15h2v3h3v2H4zM18 15h2v5h-5v-2h3z",menu:"M4 6h16v2H4zM4 11h16v2H4zM4 16h16v2H4z",theme:"M12 3a9 9 0 1 0 9 9 7 7 0 0 1-9-9z",help:"M11 17h2v2h-2zM12 4a5 5 0 0 0-5 5h2a3 3 0 1 1 4.6 2.5C12.2 12.4 11 13.3 11 15h2c0-1 .7-1.500 1.700-2.200A5 5 0 0 0 12 4z",camera:"M9 5l-1.500 2H4v12h16V7h-3.500L15 5zM12 9.500a3.500 3.500 0 1 1 0 7 3.500 3.500 0 0 1 0-7z",plots:"M4 4h2v14h14v2H4zM8 15l4-6 3 3 4-7 1.600 1L15.500 15l-3-3L9.600 16z",loop:"M7 7h10v3l4-4-4-4v3H5v6h2zM17 17H7v-3l-4 4 4 4v-3h12v-6h-2z"};function nd(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",F_[i]??""),e.append(t),e}function Vi(i,e,t){return Z("button.icon",{title:e,"aria-label":e,onclick:t,type:"button"},nd(i))}var Sm={};U_(Sm,{compose:()=>ym,film:()=>Z3,picture:()=>wm,sequence:()=>X3});var ei=Uint8Array,Pi=Uint16Array,ld=Int32Array,cd=new ei([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),hd=new ei([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Eg=new ei([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Lg=function(i,e){for(var t=new Pi(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var s=new ld(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)s[r]=r-t[n]<<5|n;return{b:t,r:s}},Dg=Lg(cd,2),O_=Dg.b,sd=Dg.r;O_[28]=258,sd[258]=28;var Ng=Lg(hd,0),dP=Ng.b,Tg=Ng.r,rd=new Pi(32768);for(At=0;At<32768;++At)zs=(At&43690)>>1|(At&21845)<<1,zs=(zs&52428)>>2|(zs&13107)<<2,zs=(zs&61680)>>4|(zs&3855)<<4,rd[At]=((zs&65280)>>8|(zs&255)<<8)>>1;var zs,At,Ba=(function(i,e,t){for(var n=i.length,s=0,r=new Pi(e);s<n;++s)i[s]&&++r[i[s]-1];var o=new Pi(e);for(s=1;s<e;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(t){a=new Pi(1<<e);var l=15-e;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],h=e-i[s],u=o[i[s]-1]++<<h,f=u|(1<<h)-1;u<=f;++u)a[rd[u]>>l]=c}else for(a=new Pi(n),s=0;s<n;++s)i[s]&&(a[s]=rd[o[i[s]-1]++]>>15-i[s]);return a}),Vr=new ei(288);for(At=0;At<144;++At)Vr[At]=8;var At;for(At=144;At<256;++At)Vr[At]=9;var At;for(At=256;At<280;++At)Vr[At]=7;var At;for(At=280;At<288;++At)Vr[At]=8;var At,dc=new ei(32);for(At=0;At<32;++At)dc[At]=5;var At,k_=Ba(Vr,9,0);var B_=Ba(dc,5,0);var Ug=function(i){return(i+7)/8|0},Fg=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new ei(i.subarray(e,t))};var z_=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],pc=function(i,e,t){var n=new Error(e||z_[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,pc),!t)throw n;return n};var Hs=function(i,e,t){t<<=e&7;var n=e/8|0;i[n]|=t,i[n+1]|=t>>8},Oa=function(i,e,t){t<<=e&7;var n=e/8|0;i[n]|=t,i[n+1]|=t>>8,i[n+2]|=t>>16},id=function(i,e){for(var t=[],n=0;n<i.length;++n)i[n]&&t.push({s:n,f:i[n]});var s=t.length,r=t.slice();if(!s)return{t:kg,l:0};if(s==1){var o=new ei(t[0].s+1);return o[t[0].s]=1,{t:o,l:1}}t.sort(function(T,M){return T.f-M.f}),t.push({s:-1,f:25001});var a=t[0],l=t[1],c=0,h=1,u=2;for(t[0]={s:-1,f:a.f+l.f,l:a,r:l};h!=s-1;)a=t[t[c].f<t[u].f?c++:u++],l=t[c!=h&&t[c].f<t[u].f?c++:u++],t[h++]={s:-1,f:a.f+l.f,l:a,r:l};for(var f=r[0].s,n=1;n<s;++n)r[n].s>f&&(f=r[n].s);var d=new Pi(f+1),p=od(t[h-1],d,0);if(p>e){var n=0,b=0,m=p-e,g=1<<m;for(r.sort(function(M,v){return d[v.s]-d[M.s]||M.f-v.f});n<s;++n){var x=r[n].s;if(d[x]>e)b+=g-(1<<p-d[x]),d[x]=e;else break}for(b>>=m;b>0;){var _=r[n].s;d[_]<e?b-=1<<e-d[_]++-1:++n}for(;n>=0&&b;--n){var y=r[n].s;d[y]==e&&(--d[y],++b)}p=e}return{t:new ei(d),l:p}},od=function(i,e,t){return i.s==-1?Math.max(od(i.l,e,t+1),od(i.r,e,t+1)):e[i.s]=t},Ag=function(i){for(var e=i.length;e&&!i[--e];);for(var t=new Pi(++e),n=0,s=i[0],r=1,o=function(l){t[n++]=l},a=1;a<=e;++a)if(i[a]==s&&a!=e)++r;else{if(!s&&r>2){for(;r>138;r-=138)o(32754);r>2&&(o(r>10?r-11<<5|28690:r-3<<5|12305),r=0)}else if(r>3){for(o(s),--r;r>6;r-=6)o(8304);r>2&&(o(r-3<<5|8208),r=0)}for(;r--;)o(s);r=1,s=i[a]}return{c:t.subarray(0,n),n:e}},ka=function(i,e){for(var t=0,n=0;n<e.length;++n)t+=i[n]*e[n];return t},Og=function(i,e,t){var n=t.length,s=Ug(e+2);i[s]=n&255,i[s+1]=n>>8,i[s+2]=i[s]^255,i[s+3]=i[s+1]^255;for(var r=0;r<n;++r)i[s+r+4]=t[r];return(s+4+n)*8},Rg=function(i,e,t,n,s,r,o,a,l,c,h){Hs(e,h++,t),++s[256];for(var u=id(s,15),f=u.t,d=u.l,p=id(r,15),b=p.t,m=p.l,g=Ag(f),x=g.c,_=g.n,y=Ag(b),T=y.c,M=y.n,v=new Pi(19),S=0;S<x.length;++S)++v[x[S]&31];for(var S=0;S<T.length;++S)++v[T[S]&31];for(var C=id(v,7),P=C.t,L=C.l,O=19;O>4&&!P[Eg[O-1]];--O);var z=c+5<<3,U=ka(s,Vr)+ka(r,dc)+o,G=ka(s,f)+ka(r,b)+o+14+3*O+ka(v,P)+2*v[16]+3*v[17]+7*v[18];if(l>=0&&z<=U&&z<=G)return Og(e,h,i.subarray(l,l+c));var q,H,ae,Y;if(Hs(e,h,1+(G<U)),h+=2,G<U){q=Ba(f,d,0),H=f,ae=Ba(b,m,0),Y=b;var ee=Ba(P,L,0);Hs(e,h,_-257),Hs(e,h+5,M-1),Hs(e,h+10,O-4),h+=14;for(var S=0;S<O;++S)Hs(e,h+3*S,P[Eg[S]]);h+=3*O;for(var te=[x,T],de=0;de<2;++de)for(var ce=te[de],S=0;S<ce.length;++S){var K=ce[S]&31;Hs(e,h,ee[K]),h+=P[K],K>15&&(Hs(e,h,ce[S]>>5&127),h+=ce[S]>>12)}}else q=k_,H=Vr,ae=B_,Y=dc;for(var S=0;S<a;++S){var ue=n[S];if(ue>255){var K=ue>>18&31;Oa(e,h,q[K+257]),h+=H[K+257],K>7&&(Hs(e,h,ue>>23&31),h+=cd[K]);var ge=ue&31;Oa(e,h,ae[ge]),h+=Y[ge],ge>3&&(Oa(e,h,ue>>5&8191),h+=hd[ge])}else Oa(e,h,q[ue]),h+=H[ue]}return Oa(e,h,q[256]),h+H[256]},H_=new ld([65540,131080,131088,131104,262176,1048704,1048832,2114560,2117632]),kg=new ei(0),V_=function(i,e,t,n,s,r){var o=r.z||i.length,a=new ei(n+o+5*(1+Math.ceil(o/7e3))+s),l=a.subarray(n,a.length-s),c=r.l,h=(r.r||0)&7;if(e){h&&(l[0]=r.r>>3);for(var u=H_[e-1],f=u>>13,d=u&8191,p=(1<<t)-1,b=r.p||new Pi(32768),m=r.h||new Pi(p+1),g=Math.ceil(t/3),x=2*g,_=function(Ze){return(i[Ze]^i[Ze+1]<<g^i[Ze+2]<<x)&p},y=new ld(25e3),T=new Pi(288),M=new Pi(32),v=0,S=0,C=r.i||0,P=0,L=r.w||0,O=0;C+2<o;++C){var z=_(C),U=C&32767,G=m[z];if(b[U]=G,m[z]=U,L<=C){var q=o-C;if((v>7e3||P>24576)&&(q>423||!c)){h=Rg(i,l,0,y,T,M,S,P,O,C-O,h),P=v=S=0,O=C;for(var H=0;H<286;++H)T[H]=0;for(var H=0;H<30;++H)M[H]=0}var ae=2,Y=0,ee=d,te=U-G&32767;if(q>2&&z==_(C-te))for(var de=Math.min(f,q)-1,ce=Math.min(32767,C),K=Math.min(258,q);te<=ce&&--ee&&U!=G;){if(i[C+ae]==i[C+ae-te]){for(var ue=0;ue<K&&i[C+ue]==i[C+ue-te];++ue);if(ue>ae){if(ae=ue,Y=te,ue>de)break;for(var ge=Math.min(te,ue-2),Me=0,H=0;H<ge;++H){var xe=C-te+H&32767,Ge=b[xe],it=xe-Ge&32767;it>Me&&(Me=it,G=xe)}}}U=G,G=b[U],te+=U-G&32767}if(Y){y[P++]=268435456|sd[ae]<<18|Tg[Y];var He=sd[ae]&31,ct=Tg[Y]&31;S+=cd[He]+hd[ct],++T[257+He],++M[ct],L=C+ae,++v}else y[P++]=i[C],++T[i[C]]}}for(C=Math.max(C,L);C<o;++C)y[P++]=i[C],++T[i[C]];h=Rg(i,l,c,y,T,M,S,P,O,C-O,h),c||(r.r=h&7|l[h/8|0]<<3,h-=7,r.h=m,r.p=b,r.i=C,r.w=L)}else{for(var C=r.w||0;C<o+c;C+=65535){var at=C+65535;at>=o&&(l[h/8|0]=c,at=o),h=Og(l,h+1,i.subarray(C,at))}r.i=o}return Fg(a,0,n+Ug(h)+s)},G_=(function(){for(var i=new Int32Array(256),e=0;e<256;++e){for(var t=e,n=9;--n;)t=(t&1&&-306674912)^t>>>1;i[e]=t}return i})(),W_=function(){var i=-1;return{p:function(e){for(var t=i,n=0;n<e.length;++n)t=G_[t&255^e[n]]^t>>>8;i=t},d:function(){return~i}}};var X_=function(i,e,t,n,s){if(!s&&(s={l:1},e.dictionary)){var r=e.dictionary.subarray(-32768),o=new ei(r.length+i.length);o.set(r),o.set(i,r.length),i=o,s.w=r.length}return V_(i,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(i.length)))*1.5):20:12+e.mem,t,n,s)},Bg=function(i,e){var t={};for(var n in i)t[n]=i[n];for(var n in e)t[n]=e[n];return t};var qn=function(i,e,t){for(;t;++e)i[e]=t,t>>>=8};function q_(i,e){return X_(i,e||{},0,0)}var zg=function(i,e,t,n){for(var s in i){var r=i[s],o=e+s,a=n;Array.isArray(r)&&(a=Bg(n,r[1]),r=r[0]),ArrayBuffer.isView(r)?t[o]=[r,a]:(t[o+="/"]=[new ei(0),a],zg(r,o,t,n))}},Cg=typeof TextEncoder<"u"&&new TextEncoder,$_=typeof TextDecoder<"u"&&new TextDecoder,Y_=0;try{$_.decode(kg,{stream:!0}),Y_=1}catch{}function Pg(i,e){if(e){for(var t=new ei(i.length),n=0;n<i.length;++n)t[n]=i.charCodeAt(n);return t}if(Cg)return Cg.encode(i);for(var s=i.length,r=new ei(i.length+(i.length>>1)),o=0,a=function(h){r[o++]=h},n=0;n<s;++n){if(o+5>r.length){var l=new ei(o+8+(s-n<<1));l.set(r),r=l}var c=i.charCodeAt(n);c<128||e?a(c):c<2048?(a(192|c>>6),a(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|i.charCodeAt(++n)&1023,a(240|c>>18),a(128|c>>12&63),a(128|c>>6&63),a(128|c&63)):(a(224|c>>12),a(128|c>>6&63),a(128|c&63))}return Fg(r,0,o)}var ad=function(i){var e=0;if(i)for(var t in i){var n=i[t].length;n>65535&&pc(9),e+=n+4}return e},Ig=function(i,e,t,n,s,r,o,a){var l=n.length,c=t.extra,h=a&&a.length,u=ad(c);qn(i,e,o!=null?33639248:67324752),e+=4,o!=null&&(i[e++]=20,i[e++]=t.os),i[e]=20,e+=2,i[e++]=t.flag<<1|(r<0&&8),i[e++]=s&&8,i[e++]=t.compression&255,i[e++]=t.compression>>8;var f=new Date(t.mtime==null?Date.now():t.mtime),d=f.getFullYear()-1980;if((d<0||d>119)&&pc(10),qn(i,e,d<<25|f.getMonth()+1<<21|f.getDate()<<16|f.getHours()<<11|f.getMinutes()<<5|f.getSeconds()>>1),e+=4,r!=-1&&(qn(i,e,t.crc),qn(i,e+4,r<0?-r-2:r),qn(i,e+8,t.size)),qn(i,e+12,l),qn(i,e+14,u),e+=16,o!=null&&(qn(i,e,h),qn(i,e+6,t.attrs),qn(i,e+10,o),e+=14),i.set(n,e),e+=l,u)for(var p in c){var b=c[p],m=b.length;qn(i,e,+p),qn(i,e+2,m),i.set(b,e+4),e+=4+m}return h&&(i.set(a,e),e+=h),e},j_=function(i,e,t,n,s){qn(i,e,101010256),qn(i,e+8,t),qn(i,e+10,t),qn(i,e+12,n),qn(i,e+16,s)};function Hg(i,e){e||(e={});var t={},n=[];zg(i,"",t,e);var s=0,r=0;for(var o in t){var a=t[o],l=a[0],c=a[1],h=c.level==0?0:8,u=Pg(o),f=u.length,d=c.comment,p=d&&Pg(d),b=p&&p.length,m=ad(c.extra);f>65535&&pc(11);var g=h?q_(l,c):l,x=g.length,_=W_();_.p(l),n.push(Bg(c,{size:l.length,crc:_.d(),c:g,f:u,m:p,u:f!=o.length||p&&d.length!=b,o:s,compression:h})),s+=30+f+m+x,r+=76+2*(f+m)+(b||0)+x}for(var y=new ei(r+22),T=s,M=r-s,v=0;v<n.length;++v){var u=n[v];Ig(y,u.o,u,u.f,u.u,u.c.length);var S=30+u.f.length+ad(u.extra);y.set(u.c,u.o+S),Ig(y,s,u,u.f,u.u,u.c.length,u.o,u.m),s+=16+S+(u.m?u.m.length:0)}return j_(y,s,n.length,M,T),y}function Ro(i,e,t){i.prototype=e.prototype=t,t.constructor=i}function Va(i,e){var t=Object.create(i.prototype);for(var n in e)t[n]=e[n];return t}function _r(){}var qr=.7,Ao=1/qr,Eo="\\s*([+-]?\\d+)\\s*",za="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)\\s*",ys="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)%\\s*",Z_=/^#([0-9a-f]{3,8})$/,J_=new RegExp(`^rgb\\(${Eo},${Eo},${Eo}\\)$`),K_=new RegExp(`^rgb\\(${ys},${ys},${ys}\\)$`),Q_=new RegExp(`^rgba\\(${Eo},${Eo},${Eo},${za}\\)$`),e1=new RegExp(`^rgba\\(${ys},${ys},${ys},${za}\\)$`),t1=new RegExp(`^hsl\\(${za},${ys},${ys}\\)$`),n1=new RegExp(`^hsla\\(${za},${ys},${ys},${za}\\)$`),Vg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074};Ro(_r,vc,{copy(i){return Object.assign(new this.constructor,this,i)},displayable(){return this.rgb().displayable()},hex:Gg,formatHex:Gg,formatHex8:i1,formatHsl:s1,formatRgb:Wg,toString:Wg});function Gg(){return this.rgb().formatHex()}function i1(){return this.rgb().formatHex8()}function s1(){return Qg(this).formatHsl()}function Wg(){return this.rgb().formatRgb()}function vc(i){var e,t;return i=(i+"").trim().toLowerCase(),(e=Z_.exec(i))?(t=e[1].length,e=parseInt(e[1],16),t===6?Xg(e):t===3?new Bn(e>>8&15|e>>4&240,e>>4&15|e&240,(e&15)<<4|e&15,1):t===8?mc(e>>24&255,e>>16&255,e>>8&255,(e&255)/255):t===4?mc(e>>12&15|e>>8&240,e>>8&15|e>>4&240,e>>4&15|e&240,((e&15)<<4|e&15)/255):null):(e=J_.exec(i))?new Bn(e[1],e[2],e[3],1):(e=K_.exec(i))?new Bn(e[1]*255/100,e[2]*255/100,e[3]*255/100,1):(e=Q_.exec(i))?mc(e[1],e[2],e[3],e[4]):(e=e1.exec(i))?mc(e[1]*255/100,e[2]*255/100,e[3]*255/100,e[4]):(e=t1.exec(i))?Yg(e[1],e[2]/100,e[3]/100,1):(e=n1.exec(i))?Yg(e[1],e[2]/100,e[3]/100,e[4]):Vg.hasOwnProperty(i)?Xg(Vg[i]):i==="transparent"?new Bn(NaN,NaN,NaN,0):null}function Xg(i){return new Bn(i>>16&255,i>>8&255,i&255,1)}function mc(i,e,t,n){return n<=0&&(i=e=t=NaN),new Bn(i,e,t,n)}function gd(i){return i instanceof _r||(i=vc(i)),i?(i=i.rgb(),new Bn(i.r,i.g,i.b,i.opacity)):new Bn}function $r(i,e,t,n){return arguments.length===1?gd(i):new Bn(i,e,t,n??1)}function Bn(i,e,t,n){this.r=+i,this.g=+e,this.b=+t,this.opacity=+n}Ro(Bn,$r,Va(_r,{brighter(i){return i=i==null?Ao:Math.pow(Ao,i),new Bn(this.r*i,this.g*i,this.b*i,this.opacity)},darker(i){return i=i==null?qr:Math.pow(qr,i),new Bn(this.r*i,this.g*i,this.b*i,this.opacity)},rgb(){return this},clamp(){return new Bn(Wr(this.r),Wr(this.g),Wr(this.b),bc(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.b<255.5&&0<=this.opacity&&this.opacity<=1},hex:qg,formatHex:qg,formatHex8:r1,formatRgb:$g,toString:$g}));function qg(){return`#${Gr(this.r)}${Gr(this.g)}${Gr(this.b)}`}function r1(){return`#${Gr(this.r)}${Gr(this.g)}${Gr(this.b)}${Gr((isNaN(this.opacity)?1:this.opacity)*255)}`}function $g(){let i=bc(this.opacity);return`${i===1?"rgb(":"rgba("}${Wr(this.r)}, ${Wr(this.g)}, ${Wr(this.b)}${i===1?")":`, ${i})`}`}function bc(i){return isNaN(i)?1:Math.max(0,Math.min(1,i))}function Wr(i){return Math.max(0,Math.min(255,Math.round(i)||0))}function Gr(i){return i=Wr(i),(i<16?"0":"")+i.toString(16)}function Yg(i,e,t,n){return n<=0?i=e=t=NaN:t<=0||t>=1?i=e=NaN:e<=0&&(i=NaN),new es(i,e,t,n)}function Qg(i){if(i instanceof es)return new es(i.h,i.s,i.l,i.opacity);if(i instanceof _r||(i=vc(i)),!i)return new es;if(i instanceof es)return i;i=i.rgb();var e=i.r/255,t=i.g/255,n=i.b/255,s=Math.min(e,t,n),r=Math.max(e,t,n),o=NaN,a=r-s,l=(r+s)/2;return a?(e===r?o=(t-n)/a+(t<n)*6:t===r?o=(n-e)/a+2:o=(e-t)/a+4,a/=l<.5?r+s:2-r-s,o*=60):a=l>0&&l<1?0:o,new es(o,a,l,i.opacity)}function yc(i,e,t,n){return arguments.length===1?Qg(i):new es(i,e,t,n??1)}function es(i,e,t,n){this.h=+i,this.s=+e,this.l=+t,this.opacity=+n}Ro(es,yc,Va(_r,{brighter(i){return i=i==null?Ao:Math.pow(Ao,i),new es(this.h,this.s,this.l*i,this.opacity)},darker(i){return i=i==null?qr:Math.pow(qr,i),new es(this.h,this.s,this.l*i,this.opacity)},rgb(){var i=this.h%360+(this.h<0)*360,e=isNaN(i)||isNaN(this.s)?0:this.s,t=this.l,n=t+(t<.5?t:1-t)*e,s=2*t-n;return new Bn(ud(i>=240?i-240:i+120,s,n),ud(i,s,n),ud(i<120?i+240:i-120,s,n),this.opacity)},clamp(){return new es(jg(this.h),gc(this.s),gc(this.l),bc(this.opacity))},displayable(){return(0<=this.s&&this.s<=1||isNaN(this.s))&&0<=this.l&&this.l<=1&&0<=this.opacity&&this.opacity<=1},formatHsl(){let i=bc(this.opacity);return`${i===1?"hsl(":"hsla("}${jg(this.h)}, ${gc(this.s)*100}%, ${gc(this.l)*100}%${i===1?")":`, ${i})`}`}}));function jg(i){return i=(i||0)%360,i<0?i+360:i}function gc(i){return Math.max(0,Math.min(1,i||0))}function ud(i,e,t){return(i<60?e+(t-e)*i/60:i<180?t:i<240?e+(t-e)*(240-i)/60:e)*255}var e0=Math.PI/180,t0=180/Math.PI,xc=18,n0=.96422,i0=1,s0=.82521,r0=4/29,To=6/29,o0=3*To*To,o1=To*To*To;function a0(i){if(i instanceof _s)return new _s(i.l,i.a,i.b,i.opacity);if(i instanceof Vs)return c0(i);i instanceof Bn||(i=gd(i));var e=md(i.r),t=md(i.g),n=md(i.b),s=fd((.2225045*e+.7168786*t+.0606169*n)/i0),r,o;return e===t&&t===n?r=o=s:(r=fd((.4360747*e+.3850649*t+.1430804*n)/n0),o=fd((.0139322*e+.0971045*t+.7141733*n)/s0)),new _s(116*s-16,500*(r-s),200*(s-o),i.opacity)}function l0(i,e,t,n){return arguments.length===1?a0(i):new _s(i,e,t,n??1)}function _s(i,e,t,n){this.l=+i,this.a=+e,this.b=+t,this.opacity=+n}Ro(_s,l0,Va(_r,{brighter(i){return new _s(this.l+xc*(i??1),this.a,this.b,this.opacity)},darker(i){return new _s(this.l-xc*(i??1),this.a,this.b,this.opacity)},rgb(){var i=(this.l+16)/116,e=isNaN(this.a)?i:i+this.a/500,t=isNaN(this.b)?i:i-this.b/200;return e=n0*dd(e),i=i0*dd(i),t=s0*dd(t),new Bn(pd(3.1338561*e-1.6168667*i-.4906146*t),pd(-.9787684*e+1.9161415*i+.033454*t),pd(.0719453*e-.2289914*i+1.4052427*t),this.opacity)}}));function fd(i){return i>o1?Math.pow(i,1/3):i/o0+r0}function dd(i){return i>To?i*i*i:o0*(i-r0)}function pd(i){return 255*(i<=.0031308?12.92*i:1.055*Math.pow(i,1/2.4)-.055)}function md(i){return(i/=255)<=.04045?i/12.92:Math.pow((i+.055)/1.055,2.4)}function a1(i){if(i instanceof Vs)return new Vs(i.h,i.c,i.l,i.opacity);if(i instanceof _s||(i=a0(i)),i.a===0&&i.b===0)return new Vs(NaN,0<i.l&&i.l<100?0:NaN,i.l,i.opacity);var e=Math.atan2(i.b,i.a)*t0;return new Vs(e<0?e+360:e,Math.sqrt(i.a*i.a+i.b*i.b),i.l,i.opacity)}function _c(i,e,t,n){return arguments.length===1?a1(i):new Vs(i,e,t,n??1)}function Vs(i,e,t,n){this.h=+i,this.c=+e,this.l=+t,this.opacity=+n}function c0(i){if(isNaN(i.h))return new _s(i.l,0,0,i.opacity);var e=i.h*e0;return new _s(i.l,Math.cos(e)*i.c,Math.sin(e)*i.c,i.opacity)}Ro(Vs,_c,Va(_r,{brighter(i){return new Vs(this.h,this.c,this.l+xc*(i??1),this.opacity)},darker(i){return new Vs(this.h,this.c,this.l-xc*(i??1),this.opacity)},rgb(){return c0(this).rgb()}}));var h0=-.14861,bd=1.78277,xd=-.29227,wc=-.90649,Ha=1.97294,Zg=Ha*wc,Jg=Ha*bd,Kg=bd*xd-wc*h0;function l1(i){if(i instanceof Xr)return new Xr(i.h,i.s,i.l,i.opacity);i instanceof Bn||(i=gd(i));var e=i.r/255,t=i.g/255,n=i.b/255,s=(Kg*n+Zg*e-Jg*t)/(Kg+Zg-Jg),r=n-s,o=(Ha*(t-s)-xd*r)/wc,a=Math.sqrt(o*o+r*r)/(Ha*s*(1-s)),l=a?Math.atan2(o,r)*t0-120:NaN;return new Xr(l<0?l+360:l,a,s,i.opacity)}function Gi(i,e,t,n){return arguments.length===1?l1(i):new Xr(i,e,t,n??1)}function Xr(i,e,t,n){this.h=+i,this.s=+e,this.l=+t,this.opacity=+n}Ro(Xr,Gi,Va(_r,{brighter(i){return i=i==null?Ao:Math.pow(Ao,i),new Xr(this.h,this.s,this.l*i,this.opacity)},darker(i){return i=i==null?qr:Math.pow(qr,i),new Xr(this.h,this.s,this.l*i,this.opacity)},rgb(){var i=isNaN(this.h)?0:(this.h+120)*e0,e=+this.l,t=isNaN(this.s)?0:this.s*e*(1-e),n=Math.cos(i),s=Math.sin(i);return new Bn(255*(e+t*(h0*n+bd*s)),255*(e+t*(xd*n+wc*s)),255*(e+t*(Ha*n)),this.opacity)}}));function d0(i,e,t,n,s){var r=i*i,o=r*i;return((1-3*i+3*r-o)*e+(4-6*r+3*o)*t+(1+3*i+3*r-3*o)*n+o*s)/6}function c1(i){var e=i.length-1;return function(t){var n=t<=0?t=0:t>=1?(t=1,e-1):Math.floor(t*e),s=i[n],r=i[n+1],o=n>0?i[n-1]:2*s-r,a=n<e-1?i[n+2]:2*r-s;return d0((t-n/e)*e,o,s,r,a)}}function h1(i){var e=i.length;return function(t){var n=Math.floor(((t%=1)<0?++t:t)*e),s=i[(n+e-1)%e],r=i[n%e],o=i[(n+1)%e],a=i[(n+2)%e];return d0((t-n/e)*e,s,r,o,a)}}var yd=i=>()=>i;function p0(i,e){return function(t){return i+t*e}}function u1(i,e,t){return i=Math.pow(i,t),e=Math.pow(e,t)-i,t=1/t,function(n){return Math.pow(i+n*e,t)}}function _d(i,e){var t=e-i;return t?p0(i,t>180||t<-180?t-360*Math.round(t/360):t):yd(isNaN(i)?e:i)}function f1(i){return(i=+i)==1?vi:function(e,t){return t-e?u1(e,t,i):yd(isNaN(e)?t:e)}}function vi(i,e){var t=e-i;return t?p0(i,t):yd(isNaN(i)?e:i)}var bP=(function i(e){var t=f1(e);function n(s,r){var o=t((s=$r(s)).r,(r=$r(r)).r),a=t(s.g,r.g),l=t(s.b,r.b),c=vi(s.opacity,r.opacity);return function(h){return s.r=o(h),s.g=a(h),s.b=l(h),s.opacity=c(h),s+""}}return n.gamma=i,n})(1);function m0(i){return function(e){var t=e.length,n=new Array(t),s=new Array(t),r=new Array(t),o,a;for(o=0;o<t;++o)a=$r(e[o]),n[o]=a.r||0,s[o]=a.g||0,r[o]=a.b||0;return n=i(n),s=i(s),r=i(r),a.opacity=1,function(l){return a.r=n(l),a.g=s(l),a.b=r(l),a+""}}}var g0=m0(c1),xP=m0(h1);function Co(i,e){return i=+i,e=+e,function(t){return i*(1-t)+e*t}}var d1=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,vP=new RegExp(d1.source,"g");var u0=180/Math.PI,vd={translateX:0,translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function b0(i,e,t,n,s,r){var o,a,l;return(o=Math.sqrt(i*i+e*e))&&(i/=o,e/=o),(l=i*t+e*n)&&(t-=i*l,n-=e*l),(a=Math.sqrt(t*t+n*n))&&(t/=a,n/=a,l/=a),i*n<e*t&&(i=-i,e=-e,l=-l,o=-o),{translateX:s,translateY:r,rotate:Math.atan2(e,i)*u0,skewX:Math.atan(l)*u0,scaleX:o,scaleY:a}}var Sc;function p1(i){let e=new(typeof DOMMatrix=="function"?DOMMatrix:WebKitCSSMatrix)(i+"");return e.isIdentity?vd:b0(e.a,e.b,e.c,e.d,e.e,e.f)}function m1(i){return i==null||(Sc||(Sc=document.createElementNS("http://www.w3.org/2000/svg","g")),Sc.setAttribute("transform",i),!(i=Sc.transform.baseVal.consolidate()))?vd:(i=i.matrix,b0(i.a,i.b,i.c,i.d,i.e,i.f))}function x0(i,e,t,n){function s(c){return c.length?c.pop()+" ":""}function r(c,h,u,f,d,p){if(c!==u||h!==f){var b=d.push("translate(",null,e,null,t);p.push({i:b-4,x:Co(c,u)},{i:b-2,x:Co(h,f)})}else(u||f)&&d.push("translate("+u+e+f+t)}function o(c,h,u,f){c!==h?(c-h>180?h+=360:h-c>180&&(c+=360),f.push({i:u.push(s(u)+"rotate(",null,n)-2,x:Co(c,h)})):h&&u.push(s(u)+"rotate("+h+n)}function a(c,h,u,f){c!==h?f.push({i:u.push(s(u)+"skewX(",null,n)-2,x:Co(c,h)}):h&&u.push(s(u)+"skewX("+h+n)}function l(c,h,u,f,d,p){if(c!==u||h!==f){var b=d.push(s(d)+"scale(",null,",",null,")");p.push({i:b-4,x:Co(c,u)},{i:b-2,x:Co(h,f)})}else(u!==1||f!==1)&&d.push(s(d)+"scale("+u+","+f+")")}return function(c,h){var u=[],f=[];return c=i(c),h=i(h),r(c.translateX,c.translateY,h.translateX,h.translateY,u,f),o(c.rotate,h.rotate,u,f),a(c.skewX,h.skewX,u,f),l(c.scaleX,c.scaleY,h.scaleX,h.scaleY,u,f),c=h=null,function(d){for(var p=-1,b=f.length,m;++p<b;)u[(m=f[p]).i]=m.x(d);return u.join("")}}}var yP=x0(p1,"px, ","px)","deg)"),_P=x0(m1,", ",")",")"),g1=1e-12;function f0(i){return((i=Math.exp(i))+1/i)/2}function b1(i){return((i=Math.exp(i))-1/i)/2}function x1(i){return((i=Math.exp(2*i))-1)/(i+1)}var wP=(function i(e,t,n){function s(r,o){var a=r[0],l=r[1],c=r[2],h=o[0],u=o[1],f=o[2],d=h-a,p=u-l,b=d*d+p*p,m,g;if(b<g1)g=Math.log(f/c)/e,m=function(v){return[a+v*d,l+v*p,c*Math.exp(e*v*g)]};else{var x=Math.sqrt(b),_=(f*f-c*c+n*b)/(2*c*t*x),y=(f*f-c*c-n*b)/(2*f*t*x),T=Math.log(Math.sqrt(_*_+1)-_),M=Math.log(Math.sqrt(y*y+1)-y);g=(M-T)/e,m=function(v){var S=v*g,C=f0(T),P=c/(t*x)*(C*x1(e*S+T)-b1(T));return[a+P*d,l+P*p,c*C/f0(e*S+T)]}}return m.duration=Math.abs(g)*1e3*e/Math.SQRT2,m}return s.rho=function(r){var o=Math.max(.001,+r),a=o*o,l=a*a;return i(o,a,l)},s})(Math.SQRT2,2,4);function v0(i){return function(e,t){var n=i((e=yc(e)).h,(t=yc(t)).h),s=vi(e.s,t.s),r=vi(e.l,t.l),o=vi(e.opacity,t.opacity);return function(a){return e.h=n(a),e.s=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var SP=v0(_d),MP=v0(vi);function y0(i){return function(e,t){var n=i((e=_c(e)).h,(t=_c(t)).h),s=vi(e.c,t.c),r=vi(e.l,t.l),o=vi(e.opacity,t.opacity);return function(a){return e.h=n(a),e.c=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var EP=y0(_d),TP=y0(vi);function _0(i){return(function e(t){t=+t;function n(s,r){var o=i((s=Gi(s)).h,(r=Gi(r)).h),a=vi(s.s,r.s),l=vi(s.l,r.l),c=vi(s.opacity,r.opacity);return function(h){return s.h=o(h),s.s=a(h),s.l=l(Math.pow(h,t)),s.opacity=c(h),s+""}}return n.gamma=e,n})(1)}var AP=_0(_d),Mc=_0(vi);function ut(i){for(var e=i.length/6|0,t=new Array(e),n=0;n<e;)t[n]="#"+i.slice(n*6,++n*6);return t}var IP=ut("1f77b4ff7f0e2ca02cd627289467bd8c564be377c27f7f7fbcbd2217becf"),LP=ut("7fc97fbeaed4fdc086ffff99386cb0f0027fbf5b17666666"),DP=ut("1b9e77d95f027570b3e7298a66a61ee6ab02a6761d666666"),NP=ut("4269d0efb118ff725c6cc5b03ca951ff8ab7a463f297bbf59c6b4e9498a0"),UP=ut("a6cee31f78b4b2df8a33a02cfb9a99e31a1cfdbf6fff7f00cab2d66a3d9affff99b15928"),FP=ut("fbb4aeb3cde3ccebc5decbe4fed9a6ffffcce5d8bdfddaecf2f2f2"),OP=ut("b3e2cdfdcdaccbd5e8f4cae4e6f5c9fff2aef1e2cccccccc"),kP=ut("e41a1c377eb84daf4a984ea3ff7f00ffff33a65628f781bf999999"),BP=ut("66c2a5fc8d628da0cbe78ac3a6d854ffd92fe5c494b3b3b3"),zP=ut("8dd3c7ffffb3bebadafb807280b1d3fdb462b3de69fccde5d9d9d9bc80bdccebc5ffed6f"),w0=ut("4e79a7f28e2ce1575976b7b259a14fedc949af7aa1ff9da79c755fbab0ab"),Ht=i=>g0(i[i.length-1]),v1=new Array(3).concat("d8b365f5f5f55ab4ac","a6611adfc27d80cdc1018571","a6611adfc27df5f5f580cdc1018571","8c510ad8b365f6e8c3c7eae55ab4ac01665e","8c510ad8b365f6e8c3f5f5f5c7eae55ab4ac01665e","8c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e","8c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e","5430058c510abf812ddfc27df6e8c3c7eae580cdc135978f01665e003c30","5430058c510abf812ddfc27df6e8c3f5f5f5c7eae580cdc135978f01665e003c30").map(ut),HP=Ht(v1),y1=new Array(3).concat("af8dc3f7f7f77fbf7b","7b3294c2a5cfa6dba0008837","7b3294c2a5cff7f7f7a6dba0008837","762a83af8dc3e7d4e8d9f0d37fbf7b1b7837","762a83af8dc3e7d4e8f7f7f7d9f0d37fbf7b1b7837","762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b7837","762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b7837","40004b762a839970abc2a5cfe7d4e8d9f0d3a6dba05aae611b783700441b","40004b762a839970abc2a5cfe7d4e8f7f7f7d9f0d3a6dba05aae611b783700441b").map(ut),VP=Ht(y1),_1=new Array(3).concat("e9a3c9f7f7f7a1d76a","d01c8bf1b6dab8e1864dac26","d01c8bf1b6daf7f7f7b8e1864dac26","c51b7de9a3c9fde0efe6f5d0a1d76a4d9221","c51b7de9a3c9fde0eff7f7f7e6f5d0a1d76a4d9221","c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221","c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221","8e0152c51b7dde77aef1b6dafde0efe6f5d0b8e1867fbc414d9221276419","8e0152c51b7dde77aef1b6dafde0eff7f7f7e6f5d0b8e1867fbc414d9221276419").map(ut),GP=Ht(_1),w1=new Array(3).concat("998ec3f7f7f7f1a340","5e3c99b2abd2fdb863e66101","5e3c99b2abd2f7f7f7fdb863e66101","542788998ec3d8daebfee0b6f1a340b35806","542788998ec3d8daebf7f7f7fee0b6f1a340b35806","5427888073acb2abd2d8daebfee0b6fdb863e08214b35806","5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b35806","2d004b5427888073acb2abd2d8daebfee0b6fdb863e08214b358067f3b08","2d004b5427888073acb2abd2d8daebf7f7f7fee0b6fdb863e08214b358067f3b08").map(ut),WP=Ht(w1),S1=new Array(3).concat("ef8a62f7f7f767a9cf","ca0020f4a58292c5de0571b0","ca0020f4a582f7f7f792c5de0571b0","b2182bef8a62fddbc7d1e5f067a9cf2166ac","b2182bef8a62fddbc7f7f7f7d1e5f067a9cf2166ac","b2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac","b2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac","67001fb2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac053061","67001fb2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac053061").map(ut),S0=Ht(S1),M1=new Array(3).concat("ef8a62ffffff999999","ca0020f4a582bababa404040","ca0020f4a582ffffffbababa404040","b2182bef8a62fddbc7e0e0e09999994d4d4d","b2182bef8a62fddbc7ffffffe0e0e09999994d4d4d","b2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d","b2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d","67001fb2182bd6604df4a582fddbc7e0e0e0bababa8787874d4d4d1a1a1a","67001fb2182bd6604df4a582fddbc7ffffffe0e0e0bababa8787874d4d4d1a1a1a").map(ut),XP=Ht(M1),E1=new Array(3).concat("fc8d59ffffbf91bfdb","d7191cfdae61abd9e92c7bb6","d7191cfdae61ffffbfabd9e92c7bb6","d73027fc8d59fee090e0f3f891bfdb4575b4","d73027fc8d59fee090ffffbfe0f3f891bfdb4575b4","d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4","d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4","a50026d73027f46d43fdae61fee090e0f3f8abd9e974add14575b4313695","a50026d73027f46d43fdae61fee090ffffbfe0f3f8abd9e974add14575b4313695").map(ut),qP=Ht(E1),T1=new Array(3).concat("fc8d59ffffbf91cf60","d7191cfdae61a6d96a1a9641","d7191cfdae61ffffbfa6d96a1a9641","d73027fc8d59fee08bd9ef8b91cf601a9850","d73027fc8d59fee08bffffbfd9ef8b91cf601a9850","d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850","d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850","a50026d73027f46d43fdae61fee08bd9ef8ba6d96a66bd631a9850006837","a50026d73027f46d43fdae61fee08bffffbfd9ef8ba6d96a66bd631a9850006837").map(ut),$P=Ht(T1),A1=new Array(3).concat("fc8d59ffffbf99d594","d7191cfdae61abdda42b83ba","d7191cfdae61ffffbfabdda42b83ba","d53e4ffc8d59fee08be6f59899d5943288bd","d53e4ffc8d59fee08bffffbfe6f59899d5943288bd","d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd","d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd","9e0142d53e4ff46d43fdae61fee08be6f598abdda466c2a53288bd5e4fa2","9e0142d53e4ff46d43fdae61fee08bffffbfe6f598abdda466c2a53288bd5e4fa2").map(ut),YP=Ht(A1),R1=new Array(3).concat("e5f5f999d8c92ca25f","edf8fbb2e2e266c2a4238b45","edf8fbb2e2e266c2a42ca25f006d2c","edf8fbccece699d8c966c2a42ca25f006d2c","edf8fbccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45005824","f7fcfde5f5f9ccece699d8c966c2a441ae76238b45006d2c00441b").map(ut),jP=Ht(R1),C1=new Array(3).concat("e0ecf49ebcda8856a7","edf8fbb3cde38c96c688419d","edf8fbb3cde38c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68856a7810f7c","edf8fbbfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d6e016b","f7fcfde0ecf4bfd3e69ebcda8c96c68c6bb188419d810f7c4d004b").map(ut),ZP=Ht(C1),P1=new Array(3).concat("e0f3dba8ddb543a2ca","f0f9e8bae4bc7bccc42b8cbe","f0f9e8bae4bc7bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc443a2ca0868ac","f0f9e8ccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe08589e","f7fcf0e0f3dbccebc5a8ddb57bccc44eb3d32b8cbe0868ac084081").map(ut),JP=Ht(P1),I1=new Array(3).concat("fee8c8fdbb84e34a33","fef0d9fdcc8afc8d59d7301f","fef0d9fdcc8afc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59e34a33b30000","fef0d9fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301f990000","fff7ecfee8c8fdd49efdbb84fc8d59ef6548d7301fb300007f0000").map(ut),KP=Ht(I1),L1=new Array(3).concat("ece2f0a6bddb1c9099","f6eff7bdc9e167a9cf02818a","f6eff7bdc9e167a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf1c9099016c59","f6eff7d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016450","fff7fbece2f0d0d1e6a6bddb67a9cf3690c002818a016c59014636").map(ut),QP=Ht(L1),D1=new Array(3).concat("ece7f2a6bddb2b8cbe","f1eef6bdc9e174a9cf0570b0","f1eef6bdc9e174a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf2b8cbe045a8d","f1eef6d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0034e7b","fff7fbece7f2d0d1e6a6bddb74a9cf3690c00570b0045a8d023858").map(ut),eI=Ht(D1),N1=new Array(3).concat("e7e1efc994c7dd1c77","f1eef6d7b5d8df65b0ce1256","f1eef6d7b5d8df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0dd1c77980043","f1eef6d4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125691003f","f7f4f9e7e1efd4b9dac994c7df65b0e7298ace125698004367001f").map(ut),tI=Ht(N1),U1=new Array(3).concat("fde0ddfa9fb5c51b8a","feebe2fbb4b9f768a1ae017e","feebe2fbb4b9f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1c51b8a7a0177","feebe2fcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a0177","fff7f3fde0ddfcc5c0fa9fb5f768a1dd3497ae017e7a017749006a").map(ut),nI=Ht(U1),F1=new Array(3).concat("edf8b17fcdbb2c7fb8","ffffcca1dab441b6c4225ea8","ffffcca1dab441b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c42c7fb8253494","ffffccc7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea80c2c84","ffffd9edf8b1c7e9b47fcdbb41b6c41d91c0225ea8253494081d58").map(ut),wd=Ht(F1),O1=new Array(3).concat("f7fcb9addd8e31a354","ffffccc2e69978c679238443","ffffccc2e69978c67931a354006837","ffffccd9f0a3addd8e78c67931a354006837","ffffccd9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443005a32","ffffe5f7fcb9d9f0a3addd8e78c67941ab5d238443006837004529").map(ut),iI=Ht(O1),k1=new Array(3).concat("fff7bcfec44fd95f0e","ffffd4fed98efe9929cc4c02","ffffd4fed98efe9929d95f0e993404","ffffd4fee391fec44ffe9929d95f0e993404","ffffd4fee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c028c2d04","ffffe5fff7bcfee391fec44ffe9929ec7014cc4c02993404662506").map(ut),sI=Ht(k1),B1=new Array(3).concat("ffeda0feb24cf03b20","ffffb2fecc5cfd8d3ce31a1c","ffffb2fecc5cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cf03b20bd0026","ffffb2fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cb10026","ffffccffeda0fed976feb24cfd8d3cfc4e2ae31a1cbd0026800026").map(ut),rI=Ht(B1),z1=new Array(3).concat("deebf79ecae13182bd","eff3ffbdd7e76baed62171b5","eff3ffbdd7e76baed63182bd08519c","eff3ffc6dbef9ecae16baed63182bd08519c","eff3ffc6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b5084594","f7fbffdeebf7c6dbef9ecae16baed64292c62171b508519c08306b").map(ut),oI=Ht(z1),H1=new Array(3).concat("e5f5e0a1d99b31a354","edf8e9bae4b374c476238b45","edf8e9bae4b374c47631a354006d2c","edf8e9c7e9c0a1d99b74c47631a354006d2c","edf8e9c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45005a32","f7fcf5e5f5e0c7e9c0a1d99b74c47641ab5d238b45006d2c00441b").map(ut),aI=Ht(H1),V1=new Array(3).concat("f0f0f0bdbdbd636363","f7f7f7cccccc969696525252","f7f7f7cccccc969696636363252525","f7f7f7d9d9d9bdbdbd969696636363252525","f7f7f7d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525","fffffff0f0f0d9d9d9bdbdbd969696737373525252252525000000").map(ut),lI=Ht(V1),G1=new Array(3).concat("efedf5bcbddc756bb1","f2f0f7cbc9e29e9ac86a51a3","f2f0f7cbc9e29e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8756bb154278f","f2f0f7dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a34a1486","fcfbfdefedf5dadaebbcbddc9e9ac8807dba6a51a354278f3f007d").map(ut),cI=Ht(G1),W1=new Array(3).concat("fee0d2fc9272de2d26","fee5d9fcae91fb6a4acb181d","fee5d9fcae91fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4ade2d26a50f15","fee5d9fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181d99000d","fff5f0fee0d2fcbba1fc9272fb6a4aef3b2ccb181da50f1567000d").map(ut),hI=Ht(W1),X1=new Array(3).concat("fee6cefdae6be6550d","feeddefdbe85fd8d3cd94701","feeddefdbe85fd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3ce6550da63603","feeddefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d948018c2d04","fff5ebfee6cefdd0a2fdae6bfd8d3cf16913d94801a636037f2704").map(ut),uI=Ht(X1);function M0(i){return i=Math.max(0,Math.min(1,i)),"rgb("+Math.max(0,Math.min(255,Math.round(-4.54-i*(35.34-i*(2381.73-i*(6402.7-i*(7024.72-i*2710.57)))))))+", "+Math.max(0,Math.min(255,Math.round(32.49+i*(170.73+i*(52.82-i*(131.46-i*(176.58-i*67.37)))))))+", "+Math.max(0,Math.min(255,Math.round(81.24+i*(442.36-i*(2482.43-i*(6167.24-i*(6614.94-i*2475.67)))))))+")"}var fI=Mc(Gi(300,.5,0),Gi(-240,.5,1)),dI=Mc(Gi(-100,.75,.35),Gi(80,1.5,.8)),pI=Mc(Gi(260,.75,.35),Gi(80,1.5,.8)),mI=Gi();var gI=$r(),bI=Math.PI/3,xI=Math.PI*2/3;function E0(i){return i=Math.max(0,Math.min(1,i)),"rgb("+Math.max(0,Math.min(255,Math.round(34.61+i*(1172.33-i*(10793.56-i*(33300.12-i*(38394.49-i*14825.05)))))))+", "+Math.max(0,Math.min(255,Math.round(23.31+i*(557.33+i*(1225.33-i*(3574.96-i*(1073.77+i*707.56)))))))+", "+Math.max(0,Math.min(255,Math.round(27.2+i*(3211.1-i*(15327.97-i*(27814-i*(22569.18-i*6838.66)))))))+")"}function Ec(i){var e=i.length;return function(t){return i[Math.max(0,Math.min(e-1,Math.floor(t*e)))]}}var T0=Ec(ut("44015444025645045745055946075a46085c460a5d460b5e470d60470e6147106347116447136548146748166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde725")),A0=Ec(ut("00000401000501010601010802010902020b02020d03030f03031204041405041606051806051a07061c08071e0907200a08220b09240c09260d0a290e0b2b100b2d110c2f120d31130d34140e36150e38160f3b180f3d19103f1a10421c10441d11471e114920114b21114e22115024125325125527125829115a2a115c2c115f2d11612f116331116533106734106936106b38106c390f6e3b0f703d0f713f0f72400f74420f75440f764510774710784910784a10794c117a4e117b4f127b51127c52137c54137d56147d57157e59157e5a167e5c167f5d177f5f187f601880621980641a80651a80671b80681c816a1c816b1d816d1d816e1e81701f81721f817320817521817621817822817922827b23827c23827e24828025828125818326818426818627818827818928818b29818c29818e2a81902a81912b81932b80942c80962c80982d80992d809b2e7f9c2e7f9e2f7fa02f7fa1307ea3307ea5317ea6317da8327daa337dab337cad347cae347bb0357bb2357bb3367ab5367ab73779b83779ba3878bc3978bd3977bf3a77c03a76c23b75c43c75c53c74c73d73c83e73ca3e72cc3f71cd4071cf4070d0416fd2426fd3436ed5446dd6456cd8456cd9466bdb476adc4869de4968df4a68e04c67e24d66e34e65e44f64e55064e75263e85362e95462ea5661eb5760ec5860ed5a5fee5b5eef5d5ef05f5ef1605df2625df2645cf3655cf4675cf4695cf56b5cf66c5cf66e5cf7705cf7725cf8745cf8765cf9785df9795df97b5dfa7d5efa7f5efa815ffb835ffb8560fb8761fc8961fc8a62fc8c63fc8e64fc9065fd9266fd9467fd9668fd9869fd9a6afd9b6bfe9d6cfe9f6dfea16efea36ffea571fea772fea973feaa74feac76feae77feb078feb27afeb47bfeb67cfeb77efeb97ffebb81febd82febf84fec185fec287fec488fec68afec88cfeca8dfecc8ffecd90fecf92fed194fed395fed597fed799fed89afdda9cfddc9efddea0fde0a1fde2a3fde3a5fde5a7fde7a9fde9aafdebacfcecaefceeb0fcf0b2fcf2b4fcf4b6fcf6b8fcf7b9fcf9bbfcfbbdfcfdbf")),vI=Ec(ut("00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c431e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f3609613809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f24699025689225689326679526679727669827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305cb0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4ec63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3ed94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602de9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1fcffa4")),yI=Ec(ut("0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e05952f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a66100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a87801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba58e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9ba21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8eb42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72d24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844bf3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983ef99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724f0f921"));/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var $i={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},as={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},xb=0,op=1,vb=2;var Ol=1,yb=2,oa=3,Rs=0,gi=1,an=2,ir=0,aa=1,ap=2,lp=3,cp=4,_b=5;var eo=100,wb=101,Sb=102,Mb=103,Eb=104,Tb=200,Ab=201,Rb=202,Cb=203,hp=204,up=205,Pb=206,Ib=207,Lb=208,Db=209,Nb=210,Ub=211,Fb=212,Ob=213,kb=214,nh=0,ih=1,sh=2,$o=3,rh=4,oh=5,ah=6,lh=7,zh=0,Bb=1,zb=2,Cs=0,fp=1,dp=2,pp=3,mp=4,gp=5,bp=6,xp=7;var vp=300,to=301,la=302,Hh=303,Vh=304,ch=1e3,Ss=1001,hh=1002,qt=1003,Hb=1004;var kl=1005;var pi=1006,Gh=1007;var sr=1008;var wi=1009,yp=1010,_p=1011,ca=1012,Wh=1013,Fi=1014,Yi=1015,ls=1016,Xh=1017,qh=1018,no=1020,wp=35902,Sp=35899,Mp=1021,Ep=1022,cs=1023,js=1026,rr=1027,$h=1028,Yh=1029,Nr=1030,jh=1031;var Zh=1033,Bl=33776,zl=33777,Hl=33778,Vl=33779,Jh=35840,Kh=35841,Qh=35842,eu=35843,tu=36196,nu=37492,iu=37496,su=37488,ru=37489,Gl=37490,ou=37491,au=37808,lu=37809,cu=37810,hu=37811,uu=37812,fu=37813,du=37814,pu=37815,mu=37816,gu=37817,bu=37818,xu=37819,vu=37820,yu=37821,_u=36492,wu=36494,Su=36495,Mu=36283,Eu=36284,Wl=36285,Tu=36286;var nl=2300,uh=2301,eh=2302,Yd=2303,jd=2400,Zd=2401,Jd=2402;var Vb=3200;var Au=0,Gb=1,or="",fi="srgb",il="srgb-linear",sl="linear",Pt="srgb";var th=7680;var Wb=519,Xb=512,qb=513,$b=514,Tp=515,Yb=516,jb=517,Ap=518,Rp=519,Cp=35044,Xl=35048;var Pp="300 es",Xi=2e3,Yo=2001;function q1(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function $1(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function rl(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Zb(){let i=rl("canvas");return i.style.display="block",i}var R0={},jo=null;function ol(...i){let e="THREE."+i.shift();jo?jo("log",e,...i):console.log(e,...i)}function Jb(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ye(...i){i=Jb(i);let e="THREE."+i.shift();if(jo)jo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function nt(...i){i=Jb(i);let e="THREE."+i.shift();if(jo)jo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ja(...i){let e=i.join(" ");e in R0||(R0[e]=!0,Ye(...i))}function Kb(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Qb={[nh]:nh,[sh]:ah,[rh]:rh,[$o]:oh,[ih]:ih,[ah]:sh,[lh]:lh,[oh]:$o},ss=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},ti=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],C0=1234567,Ka=Math.PI/180,Zo=180/Math.PI;function ar(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(ti[i&255]+ti[i>>8&255]+ti[i>>16&255]+ti[i>>24&255]+"-"+ti[e&255]+ti[e>>8&255]+"-"+ti[e>>16&15|64]+ti[e>>24&255]+"-"+ti[t&63|128]+ti[t>>8&255]+"-"+ti[t>>16&255]+ti[t>>24&255]+ti[n&255]+ti[n>>8&255]+ti[n>>16&255]+ti[n>>24&255]).toLowerCase()}function rt(i,e,t){return Math.max(e,Math.min(t,i))}function Ip(i,e){return(i%e+e)%e}function Y1(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function j1(i,e,t){return i!==e?(t-i)/(e-i):0}function Qa(i,e,t){return(1-t)*i+t*e}function Z1(i,e,t,n){return Qa(i,e,1-Math.exp(-t*n))}function J1(i,e=1){return e-Math.abs(Ip(i,e*2)-e)}function K1(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Q1(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function ew(i,e){return i+Math.floor(Math.random()*(e-i+1))}function tw(i,e){return i+Math.random()*(e-i)}function nw(i){return i*(.5-Math.random())}function iw(i){i!==void 0&&(C0=i);let e=C0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function sw(i){return i*Ka}function rw(i){return i*Zo}function ow(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function aw(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Lp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function lw(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),f=o((e-n)/2),d=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*d,a*c);break;case"YXY":i.set(l*d,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*d,a*h,a*c);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ru(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Dp(i,e){if(e.constructor===Float32Array)return i;let t=Ru(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Np(i,e){if(e.constructor===Float32Array)return i;let t=Ru(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Hn={DEG2RAD:Ka,RAD2DEG:Zo,generateUUID:ar,clamp:rt,euclideanModulo:Ip,mapLinear:Y1,inverseLerp:j1,lerp:Qa,damp:Z1,pingpong:J1,smoothstep:K1,smootherstep:Q1,randInt:ew,randFloat:tw,randFloatSpread:nw,seededRandom:iw,degToRad:sw,radToDeg:rw,isPowerOfTwo:ow,ceilPowerOfTwo:aw,floorPowerOfTwo:Lp,setQuaternionFromProperEuler:lw,normalize:Np,denormalize:Dp},we=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=rt(this.x,e.x,t.x),this.y=rt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=rt(this.x,e,t),this.y=rt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(rt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(rt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},mi=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],d=r[o+1],p=r[o+2],b=r[o+3];if(u!==b||l!==f||c!==d||h!==p){let m=l*f+c*d+h*p+u*b;m<0&&(f=-f,d=-d,p=-p,b=-b,m=-m);let g=1-a;if(m<.9995){let x=Math.acos(m),_=Math.sin(x);g=Math.sin(g*x)/_,a=Math.sin(a*x)/_,l=l*g+f*a,c=c*g+d*a,h=h*g+p*a,u=u*g+b*a}else{l=l*g+f*a,c=c*g+d*a,h=h*g+p*a,u=u*g+b*a;let x=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=x,c*=x,h*=x,u*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+h*u+l*d-c*f,e[t+1]=l*p+h*f+c*u-a*d,e[t+2]=c*p+h*d+a*f-l*u,e[t+3]=h*p-a*u-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"YXZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"ZXY":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"ZYX":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"YZX":this._x=f*h*u+c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u-f*d*p;break;case"XZY":this._x=f*h*u-c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u+f*d*p;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],f=n+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(rt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},I=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(P0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(P0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=rt(this.x,e.x,t.x),this.y=rt(this.y,e.y,t.y),this.z=rt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=rt(this.x,e,t),this.y=rt(this.y,e,t),this.z=rt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(rt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Sd.copy(this).projectOnVector(e),this.sub(Sd)}reflect(e){return this.sub(Sd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(rt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Sd=new I,P0=new mi,Qe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],d=n[5],p=n[8],b=s[0],m=s[3],g=s[6],x=s[1],_=s[4],y=s[7],T=s[2],M=s[5],v=s[8];return r[0]=o*b+a*x+l*T,r[3]=o*m+a*_+l*M,r[6]=o*g+a*y+l*v,r[1]=c*b+h*x+u*T,r[4]=c*m+h*_+u*M,r[7]=c*g+h*y+u*v,r[2]=f*b+d*x+p*T,r[5]=f*m+d*_+p*M,r[8]=f*g+d*y+p*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,p=t*u+n*f+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/p;return e[0]=u*b,e[1]=(s*c-h*n)*b,e[2]=(a*n-s*o)*b,e[3]=f*b,e[4]=(h*t-s*l)*b,e[5]=(s*r-a*t)*b,e[6]=d*b,e[7]=(n*l-c*t)*b,e[8]=(o*t-n*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ja("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Md.makeScale(e,t)),this}rotate(e){return Ja("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Md.makeRotation(-e)),this}translate(e,t){return Ja("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Md.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Md=new Qe,I0=new Qe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),L0=new Qe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function cw(){let i={enabled:!0,workingColorSpace:il,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=Ys(s.r),s.g=Ys(s.g),s.b=Ys(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=qo(s.r),s.g=qo(s.g),s.b=qo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===or?sl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[il]:{primaries:e,whitePoint:n,transfer:sl,toXYZ:I0,fromXYZ:L0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:fi},outputColorSpaceConfig:{drawingBufferColorSpace:fi}},[fi]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:I0,fromXYZ:L0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:fi}}}),i}var yt=cw();function Ys(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function qo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Po,fh=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Po===void 0&&(Po=rl("canvas")),Po.width=e.width,Po.height=e.height;let s=Po.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Po}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=rl("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ys(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ys(t[n]/255)*255):t[n]=Ys(t[n]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},hw=0,Jo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:hw++}),this.uuid=ar(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ed(s[o].image)):r.push(Ed(s[o]))}else r=Ed(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Ed(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?fh.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var uw=0,Td=new I,yi=class i extends ss{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Ss,s=Ss,r=pi,o=sr,a=cs,l=wi,c=i.DEFAULT_ANISOTROPY,h=or){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:uw++}),this.uuid=ar(),this.name="",this.source=new Jo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new we(0,0),this.repeat=new we(1,1),this.center=new we(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Td).x}get height(){return this.source.getSize(Td).y}get depth(){return this.source.getSize(Td).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==vp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ch:e.x=e.x-Math.floor(e.x);break;case Ss:e.x=e.x<0?0:1;break;case hh:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ch:e.y=e.y-Math.floor(e.y);break;case Ss:e.y=e.y<0?0:1;break;case hh:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};yi.DEFAULT_IMAGE=null;yi.DEFAULT_MAPPING=vp;yi.DEFAULT_ANISOTROPY=1;var It=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],p=l[9],b=l[2],m=l[6],g=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-b)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+b)<.1&&Math.abs(p+m)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let _=(c+1)/2,y=(d+1)/2,T=(g+1)/2,M=(h+f)/4,v=(u+b)/4,S=(p+m)/4;return _>y&&_>T?_<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(_),s=M/n,r=v/n):y>T?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=M/s,r=S/s):T<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),n=v/r,s=S/r),this.set(n,s,r,t),this}let x=Math.sqrt((m-p)*(m-p)+(u-b)*(u-b)+(f-h)*(f-h));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(u-b)/x,this.z=(f-h)/x,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=rt(this.x,e.x,t.x),this.y=rt(this.y,e.y,t.y),this.z=rt(this.z,e.z,t.z),this.w=rt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=rt(this.x,e,t),this.y=rt(this.y,e,t),this.z=rt(this.z,e,t),this.w=rt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(rt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},dh=class extends ss{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:pi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new It(0,0,e,t),this.scissorTest=!1,this.viewport=new It(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new yi({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:pi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Jo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},$n=class extends dh{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},al=class extends yi{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=qt,this.minFilter=qt,this.wrapR=Ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ph=class extends yi{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=qt,this.minFilter=qt,this.wrapR=Ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var xt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,f,d,p,b,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,f,d,p,b,m)}set(e,t,n,s,r,o,a,l,c,h,u,f,d,p,b,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=f,g[3]=d,g[7]=p,g[11]=b,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Io.setFromMatrixColumn(e,0).length(),r=1/Io.setFromMatrixColumn(e,1).length(),o=1/Io.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let f=o*h,d=o*u,p=a*h,b=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=d+p*c,t[5]=f-b*c,t[9]=-a*l,t[2]=b-f*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*h,d=l*u,p=c*h,b=c*u;t[0]=f+b*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=d*a-p,t[6]=b+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*h,d=l*u,p=c*h,b=c*u;t[0]=f-b*a,t[4]=-o*u,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*h,t[9]=b-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*h,d=o*u,p=a*h,b=a*u;t[0]=l*h,t[4]=p*c-d,t[8]=f*c+b,t[1]=l*u,t[5]=b*c+f,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*h,t[4]=b-f*u,t[8]=p*u+d,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=d*u+p,t[10]=f-b*u}else if(e.order==="XZY"){let f=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=f*u+b,t[5]=o*h,t[9]=d*u-p,t[2]=p*u-d,t[6]=a*h,t[10]=b*u+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(fw,e,dw)}lookAt(e,t,n){let s=this.elements;return Ii.subVectors(e,t),Ii.lengthSq()===0&&(Ii.z=1),Ii.normalize(),wr.crossVectors(n,Ii),wr.lengthSq()===0&&(Math.abs(n.z)===1?Ii.x+=1e-4:Ii.z+=1e-4,Ii.normalize(),wr.crossVectors(n,Ii)),wr.normalize(),Tc.crossVectors(Ii,wr),s[0]=wr.x,s[4]=Tc.x,s[8]=Ii.x,s[1]=wr.y,s[5]=Tc.y,s[9]=Ii.y,s[2]=wr.z,s[6]=Tc.z,s[10]=Ii.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],d=n[13],p=n[2],b=n[6],m=n[10],g=n[14],x=n[3],_=n[7],y=n[11],T=n[15],M=s[0],v=s[4],S=s[8],C=s[12],P=s[1],L=s[5],O=s[9],z=s[13],U=s[2],G=s[6],q=s[10],H=s[14],ae=s[3],Y=s[7],ee=s[11],te=s[15];return r[0]=o*M+a*P+l*U+c*ae,r[4]=o*v+a*L+l*G+c*Y,r[8]=o*S+a*O+l*q+c*ee,r[12]=o*C+a*z+l*H+c*te,r[1]=h*M+u*P+f*U+d*ae,r[5]=h*v+u*L+f*G+d*Y,r[9]=h*S+u*O+f*q+d*ee,r[13]=h*C+u*z+f*H+d*te,r[2]=p*M+b*P+m*U+g*ae,r[6]=p*v+b*L+m*G+g*Y,r[10]=p*S+b*O+m*q+g*ee,r[14]=p*C+b*z+m*H+g*te,r[3]=x*M+_*P+y*U+T*ae,r[7]=x*v+_*L+y*G+T*Y,r[11]=x*S+_*O+y*q+T*ee,r[15]=x*C+_*z+y*H+T*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],f=e[10],d=e[14],p=e[3],b=e[7],m=e[11],g=e[15],x=l*d-c*f,_=a*d-c*u,y=a*f-l*u,T=o*d-c*h,M=o*f-l*h,v=o*u-a*h;return t*(b*x-m*_+g*y)-n*(p*x-m*T+g*M)+s*(p*_-b*T+g*v)-r*(p*y-b*M+m*v)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],f=e[10],d=e[11],p=e[12],b=e[13],m=e[14],g=e[15],x=t*a-n*o,_=t*l-s*o,y=t*c-r*o,T=n*l-s*a,M=n*c-r*a,v=s*c-r*l,S=h*b-u*p,C=h*m-f*p,P=h*g-d*p,L=u*m-f*b,O=u*g-d*b,z=f*g-d*m,U=x*z-_*O+y*L+T*P-M*C+v*S;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/U;return e[0]=(a*z-l*O+c*L)*G,e[1]=(s*O-n*z-r*L)*G,e[2]=(b*v-m*M+g*T)*G,e[3]=(f*M-u*v-d*T)*G,e[4]=(l*P-o*z-c*C)*G,e[5]=(t*z-s*P+r*C)*G,e[6]=(m*y-p*v-g*_)*G,e[7]=(h*v-f*y+d*_)*G,e[8]=(o*O-a*P+c*S)*G,e[9]=(n*P-t*O-r*S)*G,e[10]=(p*M-b*y+g*x)*G,e[11]=(u*y-h*M-d*x)*G,e[12]=(a*C-o*L-l*S)*G,e[13]=(t*L-n*C+s*S)*G,e[14]=(b*_-p*T-m*x)*G,e[15]=(h*T-u*_+f*x)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,p=r*u,b=o*h,m=o*u,g=a*u,x=l*c,_=l*h,y=l*u,T=n.x,M=n.y,v=n.z;return s[0]=(1-(b+g))*T,s[1]=(d+y)*T,s[2]=(p-_)*T,s[3]=0,s[4]=(d-y)*M,s[5]=(1-(f+g))*M,s[6]=(m+x)*M,s[7]=0,s[8]=(p+_)*v,s[9]=(m-x)*v,s[10]=(1-(f+b))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Io.set(s[0],s[1],s[2]).length(),a=Io.set(s[4],s[5],s[6]).length(),l=Io.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ts.copy(this);let c=1/o,h=1/a,u=1/l;return ts.elements[0]*=c,ts.elements[1]*=c,ts.elements[2]*=c,ts.elements[4]*=h,ts.elements[5]*=h,ts.elements[6]*=h,ts.elements[8]*=u,ts.elements[9]*=u,ts.elements[10]*=u,t.setFromRotationMatrix(ts),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Xi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),f=(t+e)/(t-e),d=(n+s)/(n-s),p,b;if(l)p=r/(o-r),b=o*r/(o-r);else if(a===Xi)p=-(o+r)/(o-r),b=-2*o*r/(o-r);else if(a===Yo)p=-o/(o-r),b=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Xi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),f=-(t+e)/(t-e),d=-(n+s)/(n-s),p,b;if(l)p=1/(o-r),b=o/(o-r);else if(a===Xi)p=-2/(o-r),b=-(o+r)/(o-r);else if(a===Yo)p=-1/(o-r),b=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Io=new I,ts=new xt,fw=new I(0,0,0),dw=new I(1,1,1),wr=new I,Tc=new I,Ii=new I,D0=new xt,N0=new mi,Zs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(rt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-rt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(rt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-rt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(rt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-rt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return D0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(D0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return N0.setFromEuler(this),this.setFromQuaternion(N0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Zs.DEFAULT_ORDER="XYZ";var Ko=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},pw=0,U0=new I,Lo=new mi,Gs=new xt,Ac=new I,Ga=new I,mw=new I,gw=new mi,F0=new I(1,0,0),O0=new I(0,1,0),k0=new I(0,0,1),B0={type:"added"},bw={type:"removed"},Do={type:"childadded",child:null},Ad={type:"childremoved",child:null},nn=class i extends ss{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:pw++}),this.uuid=ar(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new I,t=new Zs,n=new mi,s=new I(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new xt},normalMatrix:{value:new Qe}}),this.matrix=new xt,this.matrixWorld=new xt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ko,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Lo.setFromAxisAngle(e,t),this.quaternion.multiply(Lo),this}rotateOnWorldAxis(e,t){return Lo.setFromAxisAngle(e,t),this.quaternion.premultiply(Lo),this}rotateX(e){return this.rotateOnAxis(F0,e)}rotateY(e){return this.rotateOnAxis(O0,e)}rotateZ(e){return this.rotateOnAxis(k0,e)}translateOnAxis(e,t){return U0.copy(e).applyQuaternion(this.quaternion),this.position.add(U0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(F0,e)}translateY(e){return this.translateOnAxis(O0,e)}translateZ(e){return this.translateOnAxis(k0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Gs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ac.copy(e):Ac.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ga.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Gs.lookAt(Ga,Ac,this.up):Gs.lookAt(Ac,Ga,this.up),this.quaternion.setFromRotationMatrix(Gs),s&&(Gs.extractRotation(s.matrixWorld),Lo.setFromRotationMatrix(Gs),this.quaternion.premultiply(Lo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(B0),Do.child=e,this.dispatchEvent(Do),Do.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(bw),Ad.child=e,this.dispatchEvent(Ad),Ad.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Gs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Gs.multiply(e.parent.matrixWorld)),e.applyMatrix4(Gs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(B0),Do.child=e,this.dispatchEvent(Do),Do.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ga,e,mw),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ga,gw,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),f=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};nn.DEFAULT_UP=new I(0,1,0);nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Vt=class extends nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},xw={type:"move"},Qo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Vt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Vt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new I,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new I),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Vt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new I,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new I,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let b of e.hand.values()){let m=t.getJointPose(b,n),g=this._getHandJoint(c,b);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,p=.005;c.inputState.pinching&&f>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(xw)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Vt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},ex={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Sr={h:0,s:0,l:0},Rc={h:0,s:0,l:0};function Rd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Xe=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=fi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,yt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=yt.workingColorSpace){return this.r=e,this.g=t,this.b=n,yt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=yt.workingColorSpace){if(e=Ip(e,1),t=rt(t,0,1),n=rt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Rd(o,r,e+1/3),this.g=Rd(o,r,e),this.b=Rd(o,r,e-1/3)}return yt.colorSpaceToWorking(this,s),this}setStyle(e,t=fi){function n(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=fi){let n=ex[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ys(e.r),this.g=Ys(e.g),this.b=Ys(e.b),this}copyLinearToSRGB(e){return this.r=qo(e.r),this.g=qo(e.g),this.b=qo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=fi){return yt.workingToColorSpace(ni.copy(this),e),Math.round(rt(ni.r*255,0,255))*65536+Math.round(rt(ni.g*255,0,255))*256+Math.round(rt(ni.b*255,0,255))}getHexString(e=fi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=yt.workingColorSpace){yt.workingToColorSpace(ni.copy(this),t);let n=ni.r,s=ni.g,r=ni.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=yt.workingColorSpace){return yt.workingToColorSpace(ni.copy(this),t),e.r=ni.r,e.g=ni.g,e.b=ni.b,e}getStyle(e=fi){yt.workingToColorSpace(ni.copy(this),e);let t=ni.r,n=ni.g,s=ni.b;return e!==fi?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Sr),this.setHSL(Sr.h+e,Sr.s+t,Sr.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Sr),e.getHSL(Rc);let n=Qa(Sr.h,Rc.h,t),s=Qa(Sr.s,Rc.s,t),r=Qa(Sr.l,Rc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ni=new Xe;Xe.NAMES=ex;var ll=class extends nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Zs,this.environmentIntensity=1,this.environmentRotation=new Zs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ns=new I,Ws=new I,Cd=new I,Xs=new I,No=new I,Uo=new I,z0=new I,Pd=new I,Id=new I,Ld=new I,Dd=new It,Nd=new It,Ud=new It,Ar=class i{constructor(e=new I,t=new I,n=new I){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),ns.subVectors(e,t),s.cross(ns);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){ns.subVectors(s,t),Ws.subVectors(n,t),Cd.subVectors(e,t);let o=ns.dot(ns),a=ns.dot(Ws),l=ns.dot(Cd),c=Ws.dot(Ws),h=Ws.dot(Cd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,p=(o*h-a*l)*f;return r.set(1-d-p,p,d)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Xs)===null?!1:Xs.x>=0&&Xs.y>=0&&Xs.x+Xs.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Xs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Xs.x),l.addScaledVector(o,Xs.y),l.addScaledVector(a,Xs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Dd.setScalar(0),Nd.setScalar(0),Ud.setScalar(0),Dd.fromBufferAttribute(e,t),Nd.fromBufferAttribute(e,n),Ud.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Dd,r.x),o.addScaledVector(Nd,r.y),o.addScaledVector(Ud,r.z),o}static isFrontFacing(e,t,n,s){return ns.subVectors(n,t),Ws.subVectors(e,t),ns.cross(Ws).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ns.subVectors(this.c,this.b),Ws.subVectors(this.a,this.b),ns.cross(Ws).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;No.subVectors(s,n),Uo.subVectors(r,n),Pd.subVectors(e,n);let l=No.dot(Pd),c=Uo.dot(Pd);if(l<=0&&c<=0)return t.copy(n);Id.subVectors(e,s);let h=No.dot(Id),u=Uo.dot(Id);if(h>=0&&u<=h)return t.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(No,o);Ld.subVectors(e,r);let d=No.dot(Ld),p=Uo.dot(Ld);if(p>=0&&d<=p)return t.copy(r);let b=d*c-l*p;if(b<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(Uo,a);let m=h*p-d*u;if(m<=0&&u-h>=0&&d-p>=0)return z0.subVectors(r,s),a=(u-h)/(u-h+(d-p)),t.copy(s).addScaledVector(z0,a);let g=1/(m+b+f);return o=b*g,a=f*g,t.copy(n).addScaledVector(No,o).addScaledVector(Uo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},$t=class{constructor(e=new I(1/0,1/0,1/0),t=new I(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(is.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(is.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=is.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,is):is.fromBufferAttribute(r,o),is.applyMatrix4(e.matrixWorld),this.expandByPoint(is);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Cc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Cc.copy(n.boundingBox)),Cc.applyMatrix4(e.matrixWorld),this.union(Cc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,is),is.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Wa),Pc.subVectors(this.max,Wa),Fo.subVectors(e.a,Wa),Oo.subVectors(e.b,Wa),ko.subVectors(e.c,Wa),Mr.subVectors(Oo,Fo),Er.subVectors(ko,Oo),Yr.subVectors(Fo,ko);let t=[0,-Mr.z,Mr.y,0,-Er.z,Er.y,0,-Yr.z,Yr.y,Mr.z,0,-Mr.x,Er.z,0,-Er.x,Yr.z,0,-Yr.x,-Mr.y,Mr.x,0,-Er.y,Er.x,0,-Yr.y,Yr.x,0];return!Fd(t,Fo,Oo,ko,Pc)||(t=[1,0,0,0,1,0,0,0,1],!Fd(t,Fo,Oo,ko,Pc))?!1:(Ic.crossVectors(Mr,Er),t=[Ic.x,Ic.y,Ic.z],Fd(t,Fo,Oo,ko,Pc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,is).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(is).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(qs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),qs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),qs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),qs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),qs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),qs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),qs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),qs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(qs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},qs=[new I,new I,new I,new I,new I,new I,new I,new I],is=new I,Cc=new $t,Fo=new I,Oo=new I,ko=new I,Mr=new I,Er=new I,Yr=new I,Wa=new I,Pc=new I,Ic=new I,jr=new I;function Fd(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){jr.fromArray(i,r);let a=s.x*Math.abs(jr.x)+s.y*Math.abs(jr.y)+s.z*Math.abs(jr.z),l=e.dot(jr),c=t.dot(jr),h=n.dot(jr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Sn=new I,Lc=new we,vw=0,dn=class extends ss{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:vw++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Cp,this.updateRanges=[],this.gpuType=Yi,this.version=0,this._normalizationScale=e!==void 0?Ru(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Lc.fromBufferAttribute(this,t),Lc.applyMatrix3(e),this.setXY(t,Lc.x,Lc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Sn.fromBufferAttribute(this,t),Sn.applyMatrix3(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Sn.fromBufferAttribute(this,t),Sn.applyMatrix4(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Sn.fromBufferAttribute(this,t),Sn.applyNormalMatrix(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Sn.fromBufferAttribute(this,t),Sn.transformDirection(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Dp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Np(e,this.array)}};var cl=class extends dn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var hl=class extends dn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Ke=class extends dn{constructor(e,t,n){super(new Float32Array(e),t,n)}},yw=new $t,Xa=new I,Od=new I,ii=class{constructor(e=new I,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):yw.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Xa.subVectors(e,this.center);let t=Xa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Xa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Od.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Xa.copy(e.center).add(Od)),this.expandByPoint(Xa.copy(e.center).sub(Od))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},_w=0,Wi=new xt,kd=new nn,Bo=new I,Li=new $t,qa=new $t,zn=new I,gt=class i extends ss{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:_w++}),this.uuid=ar(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(q1(e)?hl:cl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Qe().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Wi.makeRotationFromQuaternion(e),this.applyMatrix4(Wi),this}rotateX(e){return Wi.makeRotationX(e),this.applyMatrix4(Wi),this}rotateY(e){return Wi.makeRotationY(e),this.applyMatrix4(Wi),this}rotateZ(e){return Wi.makeRotationZ(e),this.applyMatrix4(Wi),this}translate(e,t,n){return Wi.makeTranslation(e,t,n),this.applyMatrix4(Wi),this}scale(e,t,n){return Wi.makeScale(e,t,n),this.applyMatrix4(Wi),this}lookAt(e){return kd.lookAt(e),kd.updateMatrix(),this.applyMatrix4(kd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Bo).negate(),this.translate(Bo.x,Bo.y,Bo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ke(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new $t);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new I(-1/0,-1/0,-1/0),new I(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];Li.setFromBufferAttribute(r),this.morphTargetsRelative?(zn.addVectors(this.boundingBox.min,Li.min),this.boundingBox.expandByPoint(zn),zn.addVectors(this.boundingBox.max,Li.max),this.boundingBox.expandByPoint(zn)):(this.boundingBox.expandByPoint(Li.min),this.boundingBox.expandByPoint(Li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ii);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new I,1/0);return}if(e){let n=this.boundingSphere.center;if(Li.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];qa.setFromBufferAttribute(a),this.morphTargetsRelative?(zn.addVectors(Li.min,qa.min),Li.expandByPoint(zn),zn.addVectors(Li.max,qa.max),Li.expandByPoint(zn)):(Li.expandByPoint(qa.min),Li.expandByPoint(qa.max))}Li.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)zn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(zn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)zn.fromBufferAttribute(a,c),l&&(Bo.fromBufferAttribute(e,c),zn.add(Bo)),s=Math.max(s,n.distanceToSquared(zn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new dn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let C=0;C<n.count;C++)a[C]=new I,l[C]=new I;let h=new I,u=new I,f=new I,d=new we,p=new we,b=new we,m=new I,g=new I;function x(C,P,L){c[C]=c[P]=c[L]=1,h.fromBufferAttribute(n,C),u.fromBufferAttribute(n,P),f.fromBufferAttribute(n,L),d.fromBufferAttribute(r,C),p.fromBufferAttribute(r,P),b.fromBufferAttribute(r,L),u.sub(h),f.sub(h),p.sub(d),b.sub(d);let O=1/(p.x*b.y-b.x*p.y);isFinite(O)&&(m.copy(u).multiplyScalar(b.y).addScaledVector(f,-p.y).multiplyScalar(O),g.copy(f).multiplyScalar(p.x).addScaledVector(u,-b.x).multiplyScalar(O),a[C].add(m),a[P].add(m),a[L].add(m),l[C].add(g),l[P].add(g),l[L].add(g))}let _=this.groups;_.length===0&&(_=[{start:0,count:e.count}]);for(let C=0,P=_.length;C<P;++C){let L=_[C],O=L.start,z=L.count;for(let U=O,G=O+z;U<G;U+=3)x(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let y=new I,T=new I,M=new I,v=new I;function S(C){M.fromBufferAttribute(s,C),v.copy(M);let P=a[C];y.copy(P),y.sub(M.multiplyScalar(M.dot(P))).normalize(),T.crossVectors(v,P);let O=T.dot(l[C])<0?-1:1;o.setXYZW(C,y.x,y.y,y.z,O)}for(let C=0,P=n.count;C<P;++C)c[C]&&S(C);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new dn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new I,r=new I,o=new I,a=new I,l=new I,c=new I,h=new I,u=new I;if(e)for(let f=0,d=e.count;f<d;f+=3){let p=e.getX(f+0),b=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,b),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,b),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(b,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)zn.fromBufferAttribute(e,t),zn.normalize(),e.setXYZ(t,zn.x,zn.y,zn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,p=0;for(let b=0,m=l.length;b<m;b++){a.isInterleavedBufferAttribute?d=l[b]*a.data.stride+a.offset:d=l[b]*h;for(let g=0;g<h;g++)f[p++]=c[d++]}return new dn(f,h,u)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=e(f,n);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},mh=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Cp,this.updateRanges=[],this.version=0,this.uuid=ar()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=H0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=H0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function H0(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=ar()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var ui=new I,rs=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Ru(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)ui.fromBufferAttribute(this,t),ui.applyMatrix4(e),this.setXYZ(t,ui.x,ui.y,ui.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ui.fromBufferAttribute(this,t),ui.applyNormalMatrix(e),this.setXYZ(t,ui.x,ui.y,ui.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ui.fromBufferAttribute(this,t),ui.transformDirection(e),this.setXYZ(t,ui.x,ui.y,ui.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){ol("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new dn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){ol("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Dp(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Np(e,this.data.array)}},Bd=new I,ww=new I,Sw=new Qe,di=class{constructor(e=new I(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Bd.subVectors(n,t).cross(ww.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Bd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Sw.getNormalMatrix(e),s=this.coplanarPoint(Bd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Mw=0,Es=class extends ss{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Mw++}),this.uuid=ar(),this.name="",this.type="Material",this.blending=aa,this.side=Rs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=hp,this.blendDst=up,this.blendEquation=eo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Xe(0,0,0),this.blendAlpha=0,this.depthFunc=$o,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Wb,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=th,this.stencilZFail=th,this.stencilZPass=th,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Xe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new di().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new we().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new we().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var $s=new I,zd=new I,Dc=new I,Nc=new I,Js=class{constructor(e=new I,t=new I(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,$s)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=$s.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):($s.copy(this.origin).addScaledVector(this.direction,t),$s.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){zd.copy(e).add(t).multiplyScalar(.5),Dc.copy(t).sub(e).normalize(),Nc.copy(this.origin).sub(zd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Dc),a=Nc.dot(this.direction),l=-Nc.dot(Dc),c=Nc.lengthSq(),h=Math.abs(1-o*o),u,f,d,p;if(h>0)if(u=o*l-a,f=o*a-l,p=r*h,u>=0)if(f>=-p)if(f<=p){let b=1/h;u*=b,f*=b,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-p?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=p?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(zd).addScaledVector(Dc,f),d}intersectSphere(e,t){if(e.radius<0)return null;$s.subVectors(e.center,this.origin);let n=$s.dot(this.direction),s=$s.dot($s)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),h>=0?(r=(e.min.y-f.y)*h,o=(e.max.y-f.y)*h):(r=(e.max.y-f.y)*h,o=(e.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-f.z)*u,l=(e.max.z-f.z)*u):(a=(e.max.z-f.z)*u,l=(e.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,$s)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,f=e.y-o.y,d=e.z-o.z,p=t.x-o.x,b=t.y-o.y,m=t.z-o.z,g=n.x-o.x,x=n.y-o.y,_=n.z-o.z,y=Math.abs(l),T=Math.abs(c),M=Math.abs(h),v,S,C,P,L,O,z,U,G,q,H,ae;if(y>=T&&y>=M?(C=l,O=u,G=p,ae=g,l>=0?(v=c,S=h,P=f,L=d,z=b,U=m,q=x,H=_):(v=h,S=c,P=d,L=f,z=m,U=b,q=_,H=x)):T>=M?(C=c,O=f,G=b,ae=x,c>=0?(v=h,S=l,P=d,L=u,z=m,U=p,q=_,H=g):(v=l,S=h,P=u,L=d,z=p,U=m,q=g,H=_)):(C=h,O=d,G=m,ae=_,h>=0?(v=l,S=c,P=u,L=f,z=p,U=b,q=g,H=x):(v=c,S=l,P=f,L=u,z=b,U=p,q=x,H=g)),C===0)return null;let Y=v/C,ee=S/C,te=1/C,de=P-Y*O,ce=L-ee*O,K=z-Y*G,ue=U-ee*G,ge=q-Y*ae,Me=H-ee*ae,xe=ge*ue-Me*K,Ge=de*Me-ce*ge,it=K*ce-ue*de;if(s){if(xe<0||Ge<0||it<0)return null}else if((xe<0||Ge<0||it<0)&&(xe>0||Ge>0||it>0))return null;let He=xe+Ge+it;if(He===0)return null;let ct=te*(xe*O+Ge*G+it*ae);return(He>0?ct<0:ct>0)?null:this.at(ct/He,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Yn=class extends Es{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Zs,this.combine=zh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},V0=new xt,Zr=new Js,Uc=new ii,G0=new I,Fc=new I,Oc=new I,kc=new I,Hd=new I,Bc=new I,W0=new I,zc=new I,Lt=class extends nn{constructor(e=new gt,t=new Yn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Bc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Hd.fromBufferAttribute(u,e),o?Bc.addScaledVector(Hd,h):Bc.addScaledVector(Hd.sub(t),h))}t.add(Bc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Uc.copy(n.boundingSphere),Uc.applyMatrix4(r),Zr.copy(e.ray).recast(e.near),!(Uc.containsPoint(Zr.origin)===!1&&(Zr.intersectSphere(Uc,G0)===null||Zr.origin.distanceToSquared(G0)>(e.far-e.near)**2))&&(V0.copy(r).invert(),Zr.copy(e.ray).applyMatrix4(V0),!(n.boundingBox!==null&&Zr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Zr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,b=f.length;p<b;p++){let m=f[p],g=o[m.materialIndex],x=Math.max(m.start,d.start),_=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let y=x,T=_;y<T;y+=3){let M=a.getX(y),v=a.getX(y+1),S=a.getX(y+2);s=Hc(this,g,e,n,c,h,u,M,v,S),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(a.count,d.start+d.count);for(let m=p,g=b;m<g;m+=3){let x=a.getX(m),_=a.getX(m+1),y=a.getX(m+2);s=Hc(this,o,e,n,c,h,u,x,_,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,b=f.length;p<b;p++){let m=f[p],g=o[m.materialIndex],x=Math.max(m.start,d.start),_=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let y=x,T=_;y<T;y+=3){let M=y,v=y+1,S=y+2;s=Hc(this,g,e,n,c,h,u,M,v,S),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(l.count,d.start+d.count);for(let m=p,g=b;m<g;m+=3){let x=m,_=m+1,y=m+2;s=Hc(this,o,e,n,c,h,u,x,_,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Ew(i,e,t,n,s,r,o,a){let l;if(e.side===gi?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===Rs,a),l===null)return null;zc.copy(a),zc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(zc);return c<t.near||c>t.far?null:{distance:c,point:zc.clone(),object:i}}function Hc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Fc),i.getVertexPosition(l,Oc),i.getVertexPosition(c,kc);let h=Ew(i,e,t,n,Fc,Oc,kc,W0);if(h){let u=new I;Ar.getBarycoord(W0,Fc,Oc,kc,u),s&&(h.uv=Ar.getInterpolatedAttribute(s,a,l,c,u,new we)),r&&(h.uv1=Ar.getInterpolatedAttribute(r,a,l,c,u,new we)),o&&(h.normal=Ar.getInterpolatedAttribute(o,a,l,c,u,new I),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new I,materialIndex:0};Ar.getNormal(Fc,Oc,kc,f.normal),h.face=f,h.barycoord=u}return h}var Ks=class extends yi{constructor(e=null,t=1,n=1,s,r,o,a,l,c=qt,h=qt,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ul=class extends dn{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},zo=new xt,X0=new xt,Vc=[],q0=new $t,Tw=new xt,$a=new Lt,Ya=new ii,Qs=class extends Lt{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new ul(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Tw)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new $t),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,zo),q0.copy(e.boundingBox).applyMatrix4(zo),this.boundingBox.union(q0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new ii),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,zo),Ya.copy(e.boundingSphere).applyMatrix4(zo),this.boundingSphere.union(Ya)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if($a.geometry=this.geometry,$a.material=this.material,$a.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ya.copy(this.boundingSphere),Ya.applyMatrix4(n),e.ray.intersectsSphere(Ya)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,zo),X0.multiplyMatrices(n,zo),$a.matrixWorld=X0,$a.raycast(e,Vc);for(let o=0,a=Vc.length;o<a;o++){let l=Vc[o];l.instanceId=r,l.object=this,t.push(l)}Vc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new ul(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Ks(new Float32Array(s*this.count),s,this.count,$h,Yi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Jr=new ii,Aw=new we(.5,.5),Gc=new I,Rr=class{constructor(e=new di,t=new di,n=new di,s=new di,r=new di,o=new di){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Xi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],p=r[8],b=r[9],m=r[10],g=r[11],x=r[12],_=r[13],y=r[14],T=r[15];if(s[0].setComponents(c-o,d-h,g-p,T-x).normalize(),s[1].setComponents(c+o,d+h,g+p,T+x).normalize(),s[2].setComponents(c+a,d+u,g+b,T+_).normalize(),s[3].setComponents(c-a,d-u,g-b,T-_).normalize(),n)s[4].setComponents(l,f,m,y).normalize(),s[5].setComponents(c-l,d-f,g-m,T-y).normalize();else if(s[4].setComponents(c-l,d-f,g-m,T-y).normalize(),t===Xi)s[5].setComponents(c+l,d+f,g+m,T+y).normalize();else if(t===Yo)s[5].setComponents(l,f,m,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Jr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Jr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Jr)}intersectsSprite(e){Jr.center.set(0,0,0);let t=Aw.distanceTo(e.center);return Jr.radius=.7071067811865476+t,Jr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Jr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Gc.x=s.normal.x>0?e.max.x:e.min.x,Gc.y=s.normal.y>0?e.max.y:e.min.y,Gc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Gc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},$0=new xt,gh=class i{constructor(){this.coordinateSystem=Xi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];$0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Rr),n[s].setFromProjectionMatrix($0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Rr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var qi=class extends Es{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Xe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},bh=new I,xh=new I,Y0=new xt,ja=new Js,Wc=new ii,Vd=new I,j0=new I,ea=class extends nn{constructor(e=new gt,t=new qi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)bh.fromBufferAttribute(t,s-1),xh.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=bh.distanceTo(xh);e.setAttribute("lineDistance",new Ke(n,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Wc.copy(n.boundingSphere),Wc.applyMatrix4(s),Wc.radius+=r,e.ray.intersectsSphere(Wc)===!1)return;Y0.copy(s).invert(),ja.copy(e.ray).applyMatrix4(Y0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let b=d,m=p-1;b<m;b+=c){let g=h.getX(b),x=h.getX(b+1),_=Xc(this,e,ja,l,g,x,b);_&&t.push(_)}if(this.isLineLoop){let b=h.getX(p-1),m=h.getX(d),g=Xc(this,e,ja,l,b,m,p-1);g&&t.push(g)}}else{let d=Math.max(0,o.start),p=Math.min(f.count,o.start+o.count);for(let b=d,m=p-1;b<m;b+=c){let g=Xc(this,e,ja,l,b,b+1,b);g&&t.push(g)}if(this.isLineLoop){let b=Xc(this,e,ja,l,p-1,d,p-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Xc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(bh.fromBufferAttribute(a,s),xh.fromBufferAttribute(a,r),t.distanceSqToSegment(bh,xh,Vd,j0)>n)return;Vd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Vd);if(!(c<e.near||c>e.far))return{distance:c,point:j0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Z0=new I,J0=new I,er=class extends ea{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Z0.fromBufferAttribute(t,s),J0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Z0.distanceTo(J0);e.setAttribute("lineDistance",new Ke(n,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ts=class extends Es{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Xe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},K0=new xt,Kd=new Js,qc=new ii,$c=new I,tr=class extends nn{constructor(e=new gt,t=new Ts){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),qc.copy(n.boundingSphere),qc.applyMatrix4(s),qc.radius+=r,e.ray.intersectsSphere(qc)===!1)return;K0.copy(s).invert(),Kd.copy(e.ray).applyMatrix4(K0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let p=f,b=d;p<b;p++){let m=c.getX(p);$c.fromBufferAttribute(u,m),Q0($c,m,l,s,e,t,this)}}else{let f=Math.max(0,o.start),d=Math.min(u.count,o.start+o.count);for(let p=f,b=d;p<b;p++)$c.fromBufferAttribute(u,p),Q0($c,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Q0(i,e,t,n,s,r,o){let a=Kd.distanceSqToPoint(i);if(a<t){let l=new I;Kd.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var fl=class extends yi{constructor(e=[],t=to,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var os=class extends yi{constructor(e,t,n=Fi,s,r,o,a=qt,l=qt,c,h=js,u=1){if(h!==js&&h!==rr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:u};super(f,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Jo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},dl=class extends os{constructor(e,t=Fi,n=to,s,r,o=qt,a=qt,l,c=js){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},pl=class extends yi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Cr=class i extends gt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ke(c,3)),this.setAttribute("normal",new Ke(h,3)),this.setAttribute("uv",new Ke(u,2));function p(b,m,g,x,_,y,T,M,v,S,C){let P=y/v,L=T/S,O=y/2,z=T/2,U=M/2,G=v+1,q=S+1,H=0,ae=0,Y=new I;for(let ee=0;ee<q;ee++){let te=ee*L-z;for(let de=0;de<G;de++){let ce=de*P-O;Y[b]=ce*x,Y[m]=te*_,Y[g]=U,c.push(Y.x,Y.y,Y.z),Y[b]=0,Y[m]=0,Y[g]=M>0?1:-1,h.push(Y.x,Y.y,Y.z),u.push(de/v),u.push(1-ee/S),H+=1}}for(let ee=0;ee<S;ee++)for(let te=0;te<v;te++){let de=f+te+G*ee,ce=f+te+G*(ee+1),K=f+(te+1)+G*(ee+1),ue=f+(te+1)+G*ee;l.push(de,ce,ue),l.push(ce,K,ue),ae+=6}a.addGroup(d,ae,C),d+=ae,f+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var nr=class i extends gt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],p=0,b=[],m=n/2,g=0;x(),o===!1&&(e>0&&_(!0),t>0&&_(!1)),this.setIndex(h),this.setAttribute("position",new Ke(u,3)),this.setAttribute("normal",new Ke(f,3)),this.setAttribute("uv",new Ke(d,2));function x(){let y=new I,T=new I,M=0,v=(t-e)/n;for(let S=0;S<=r;S++){let C=[],P=S/r,L=P*(t-e)+e;for(let O=0;O<=s;O++){let z=O/s,U=z*l+a,G=Math.sin(U),q=Math.cos(U);T.x=L*G,T.y=-P*n+m,T.z=L*q,u.push(T.x,T.y,T.z),y.set(G,v,q).normalize(),f.push(y.x,y.y,y.z),d.push(z,1-P),C.push(p++)}b.push(C)}for(let S=0;S<s;S++)for(let C=0;C<r;C++){let P=b[C][S],L=b[C+1][S],O=b[C+1][S+1],z=b[C][S+1];(e>0||C!==0)&&(h.push(P,L,z),M+=3),(t>0||C!==r-1)&&(h.push(L,O,z),M+=3)}c.addGroup(g,M,0),g+=M}function _(y){let T=p,M=new we,v=new I,S=0,C=y===!0?e:t,P=y===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,m*P,0),f.push(0,P,0),d.push(.5,.5),p++;let L=p;for(let O=0;O<=s;O++){let U=O/s*l+a,G=Math.cos(U),q=Math.sin(U);v.x=C*q,v.y=m*P,v.z=C*G,u.push(v.x,v.y,v.z),f.push(0,P,0),M.x=G*.5+.5,M.y=q*.5*P+.5,d.push(M.x,M.y),p++}for(let O=0;O<s;O++){let z=T+O,U=L+O;y===!0?h.push(U,U+1,z):h.push(U+1,U,z),S+=3}c.addGroup(g,S,y===!0?1:2),g+=S}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},ml=class i extends nr{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},vh=class i extends gt{constructor(e=[],t=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:n,detail:s};let r=[],o=[];a(s),c(n),h(),this.setAttribute("position",new Ke(r,3)),this.setAttribute("normal",new Ke(r.slice(),3)),this.setAttribute("uv",new Ke(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let _=new I,y=new I,T=new I;for(let M=0;M<t.length;M+=3)d(t[M+0],_),d(t[M+1],y),d(t[M+2],T),l(_,y,T,x)}function l(x,_,y,T){let M=T+1,v=[];for(let S=0;S<=M;S++){v[S]=[];let C=x.clone().lerp(y,S/M),P=_.clone().lerp(y,S/M),L=M-S;for(let O=0;O<=L;O++)O===0&&S===M?v[S][O]=C:v[S][O]=C.clone().lerp(P,O/L)}for(let S=0;S<M;S++)for(let C=0;C<2*(M-S)-1;C++){let P=Math.floor(C/2);C%2===0?(f(v[S][P+1]),f(v[S+1][P]),f(v[S][P])):(f(v[S][P+1]),f(v[S+1][P+1]),f(v[S+1][P]))}}function c(x){let _=new I;for(let y=0;y<r.length;y+=3)_.x=r[y+0],_.y=r[y+1],_.z=r[y+2],_.normalize().multiplyScalar(x),r[y+0]=_.x,r[y+1]=_.y,r[y+2]=_.z}function h(){let x=new I;for(let _=0;_<r.length;_+=3){x.x=r[_+0],x.y=r[_+1],x.z=r[_+2];let y=m(x)/2/Math.PI+.5,T=g(x)/Math.PI+.5;o.push(y,1-T)}p(),u()}function u(){for(let x=0;x<o.length;x+=6){let _=o[x+0],y=o[x+2],T=o[x+4],M=Math.max(_,y,T),v=Math.min(_,y,T);M>.9&&v<.1&&(_<.2&&(o[x+0]+=1),y<.2&&(o[x+2]+=1),T<.2&&(o[x+4]+=1))}}function f(x){r.push(x.x,x.y,x.z)}function d(x,_){let y=x*3;_.x=e[y+0],_.y=e[y+1],_.z=e[y+2]}function p(){let x=new I,_=new I,y=new I,T=new I,M=new we,v=new we,S=new we;for(let C=0,P=0;C<r.length;C+=9,P+=6){x.set(r[C+0],r[C+1],r[C+2]),_.set(r[C+3],r[C+4],r[C+5]),y.set(r[C+6],r[C+7],r[C+8]),M.set(o[P+0],o[P+1]),v.set(o[P+2],o[P+3]),S.set(o[P+4],o[P+5]),T.copy(x).add(_).add(y).divideScalar(3);let L=m(T);b(M,P+0,x,L),b(v,P+2,_,L),b(S,P+4,y,L)}}function b(x,_,y,T){T<0&&x.x===1&&(o[_]=x.x-1),y.x===0&&y.z===0&&(o[_]=T/2/Math.PI+.5)}function m(x){return Math.atan2(x.z,-x.x)}function g(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.vertices,e.indices,e.radius,e.detail)}};var Di=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ye("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],f=n[s+1]-h,d=(o-h)/f;return(s+d)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new we:new I);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new I,s=[],r=[],o=[],a=new I,l=new xt;for(let d=0;d<=e;d++){let p=d/e;s[d]=this.getTangentAt(p,new I)}r[0]=new I,o[0]=new I;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),f=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let d=1;d<=e;d++){if(r[d]=r[d-1].clone(),o[d]=o[d-1].clone(),a.crossVectors(s[d-1],s[d]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(rt(s[d-1].dot(s[d]),-1,1));r[d].applyMatrix4(l.makeRotationAxis(a,p))}o[d].crossVectors(s[d],r[d])}if(t===!0){let d=Math.acos(rt(r[0].dot(r[e]),-1,1));d/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(d=-d);for(let p=1;p<=e;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],d*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},ta=class extends Di{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new we){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),f=l-this.aX,d=c-this.aY;l=f*h-d*u+this.aX,c=f*u+d*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},yh=class extends ta{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Up(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let f=(o-r)/c-(a-r)/(c+h)+(a-o)/h,d=(a-o)/h-(l-o)/(h+u)+(l-a)/u;f*=h,d*=h,s(o,a,f,d)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var eb=new I,tb=new I,Gd=new Up,Wd=new Up,Xd=new Up,Kr=class extends Di{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new I){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(tb.subVectors(s[0],s[1]).add(s[0]),c=tb);let u=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(eb.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=eb),this.curveType==="centripetal"||this.curveType==="chordal"){let d=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),d),b=Math.pow(u.distanceToSquared(f),d),m=Math.pow(f.distanceToSquared(h),d);b<1e-4&&(b=1),p<1e-4&&(p=b),m<1e-4&&(m=b),Gd.initNonuniformCatmullRom(c.x,u.x,f.x,h.x,p,b,m),Wd.initNonuniformCatmullRom(c.y,u.y,f.y,h.y,p,b,m),Xd.initNonuniformCatmullRom(c.z,u.z,f.z,h.z,p,b,m)}else this.curveType==="catmullrom"&&(Gd.initCatmullRom(c.x,u.x,f.x,h.x,this.tension),Wd.initCatmullRom(c.y,u.y,f.y,h.y,this.tension),Xd.initCatmullRom(c.z,u.z,f.z,h.z,this.tension));return n.set(Gd.calc(l),Wd.calc(l),Xd.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new I().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function nb(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function Rw(i,e){let t=1-i;return t*t*e}function Cw(i,e){return 2*(1-i)*i*e}function Pw(i,e){return i*i*e}function el(i,e,t,n){return Rw(i,e)+Cw(i,t)+Pw(i,n)}function Iw(i,e){let t=1-i;return t*t*t*e}function Lw(i,e){let t=1-i;return 3*t*t*i*e}function Dw(i,e){return 3*(1-i)*i*i*e}function Nw(i,e){return i*i*i*e}function tl(i,e,t,n,s){return Iw(i,e)+Lw(i,t)+Dw(i,n)+Nw(i,s)}var gl=class extends Di{constructor(e=new we,t=new we,n=new we,s=new we){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new we){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(tl(e,s.x,r.x,o.x,a.x),tl(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},_h=class extends Di{constructor(e=new I,t=new I,n=new I,s=new I){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new I){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(tl(e,s.x,r.x,o.x,a.x),tl(e,s.y,r.y,o.y,a.y),tl(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},bl=class extends Di{constructor(e=new we,t=new we){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new we){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new we){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},wh=class extends Di{constructor(e=new I,t=new I){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new I){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new I){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},xl=class extends Di{constructor(e=new we,t=new we,n=new we){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new we){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(el(e,s.x,r.x,o.x),el(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Sh=class extends Di{constructor(e=new I,t=new I,n=new I){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new I){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(el(e,s.x,r.x,o.x),el(e,s.y,r.y,o.y),el(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},vl=class extends Di{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new we){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(nb(a,l.x,c.x,h.x,u.x),nb(a,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new we().fromArray(s))}return this}},ib=Object.freeze({__proto__:null,ArcCurve:yh,CatmullRomCurve3:Kr,CubicBezierCurve:gl,CubicBezierCurve3:_h,EllipseCurve:ta,LineCurve:bl,LineCurve3:wh,QuadraticBezierCurve:xl,QuadraticBezierCurve3:Sh,SplineCurve:vl}),Mh=class extends Di{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let n=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new ib[n](t,e))}return this}getPoint(e,t){let n=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let n=0,s=this.curves.length;n<s;n++)t+=this.curves[n].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(t.push(h),n=h)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this.cacheLengths=null,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,n=this.curves.length;t<n;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(new ib[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},yl=class extends Mh{constructor(e){super(),this.type="Path",this.currentPoint=new we,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,n=e.length;t<n;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let n=new bl(this.currentPoint.clone(),new we(e,t));return this.curves.push(n),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,n,s){let r=new xl(this.currentPoint.clone(),new we(e,t),new we(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(e,t,n,s,r,o){let a=new gl(this.currentPoint.clone(),new we(e,t),new we(n,s),new we(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),n=new vl(t);return this.curves.push(n),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+a,t+l,n,s,r,o),this}absarc(e,t,n,s,r,o){return this.absellipse(e,t,n,n,s,r,o),this}ellipse(e,t,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(e+c,t+h,n,s,r,o,a,l),this}absellipse(e,t,n,s,r,o,a,l){let c=new ta(e,t,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},na=class extends yl{constructor(e){super(e),this.uuid=ar(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let n=0,s=this.holes.length;n<s;n++)t[n]=this.holes[n].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,n=this.holes.length;t<n;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(new yl().fromJSON(s))}return this}};function Uw(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=tx(i,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=zw(i,e,r,t)),i.length>80*t){a=i[0],l=i[1];let h=a,u=l;for(let f=t;f<s;f+=t){let d=i[f],p=i[f+1];d<a&&(a=d),p<l&&(l=p),d>h&&(h=d),p>u&&(u=p)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return _l(r,o,t,a,l,c,0),o}function tx(i,e,t,n,s){let r;if(s===Jw(i,e,t,n)>0)for(let o=e;o<t;o+=n)r=sb(o/n|0,i[o],i[o+1],r);else for(let o=t-n;o>=e;o-=n)r=sb(o/n|0,i[o],i[o+1],r);return r&&ia(r,r.next)&&(Sl(r),r=r.next),r}function Qr(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(ia(t,t.next)||on(t.prev,t,t.next)===0)){if(Sl(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function _l(i,e,t,n,s,r,o){if(!i)return;!o&&r&&Xw(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?Ow(i,n,s,r):Fw(i)){e.push(l.i,i.i,c.i),Sl(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=kw(Qr(i),e),_l(i,e,t,n,s,r,2)):o===2&&Bw(i,e,t,n,s,r):_l(Qr(i),e,t,n,s,r,1);break}}}function Fw(i){let e=i.prev,t=i,n=i.next;if(on(e,t,n)>=0)return!1;let s=e.x,r=t.x,o=n.x,a=e.y,l=t.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),f=Math.max(s,r,o),d=Math.max(a,l,c),p=n.next;for(;p!==e;){if(p.x>=h&&p.x<=f&&p.y>=u&&p.y<=d&&Za(s,a,r,l,o,c,p.x,p.y)&&on(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function Ow(i,e,t,n){let s=i.prev,r=i,o=i.next;if(on(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,f=o.y,d=Math.min(a,l,c),p=Math.min(h,u,f),b=Math.max(a,l,c),m=Math.max(h,u,f),g=Qd(d,p,e,t,n),x=Qd(b,m,e,t,n),_=i.prevZ,y=i.nextZ;for(;_&&_.z>=g&&y&&y.z<=x;){if(_.x>=d&&_.x<=b&&_.y>=p&&_.y<=m&&_!==s&&_!==o&&Za(a,h,l,u,c,f,_.x,_.y)&&on(_.prev,_,_.next)>=0||(_=_.prevZ,y.x>=d&&y.x<=b&&y.y>=p&&y.y<=m&&y!==s&&y!==o&&Za(a,h,l,u,c,f,y.x,y.y)&&on(y.prev,y,y.next)>=0))return!1;y=y.nextZ}for(;_&&_.z>=g;){if(_.x>=d&&_.x<=b&&_.y>=p&&_.y<=m&&_!==s&&_!==o&&Za(a,h,l,u,c,f,_.x,_.y)&&on(_.prev,_,_.next)>=0)return!1;_=_.prevZ}for(;y&&y.z<=x;){if(y.x>=d&&y.x<=b&&y.y>=p&&y.y<=m&&y!==s&&y!==o&&Za(a,h,l,u,c,f,y.x,y.y)&&on(y.prev,y,y.next)>=0)return!1;y=y.nextZ}return!0}function kw(i,e){let t=i;do{let n=t.prev,s=t.next.next;!ia(n,s)&&ix(n,t,t.next,s)&&wl(n,s)&&wl(s,n)&&(e.push(n.i,t.i,s.i),Sl(t),Sl(t.next),t=i=s),t=t.next}while(t!==i);return Qr(t)}function Bw(i,e,t,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&Yw(o,a)){let l=sx(o,a);o=Qr(o,o.next),l=Qr(l,l.next),_l(o,e,t,n,s,r,0),_l(l,e,t,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function zw(i,e,t,n){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*n,l=r<o-1?e[r+1]*n:i.length,c=tx(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push($w(c))}s.sort(Hw);for(let r=0;r<s.length;r++)t=Vw(s[r],t);return t}function Hw(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function Vw(i,e){let t=Gw(i,e);if(!t)return e;let n=sx(t,i);return Qr(n,n.next),Qr(t,t.next)}function Gw(i,e){let t=e,n=i.x,s=i.y,r=-1/0,o;if(ia(i,t))return t;do{if(ia(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let u=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(u<=n&&u>r&&(r=u,o=t.x<t.next.x?t:t.next,u===n))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;t=o;do{if(n>=t.x&&t.x>=l&&n!==t.x&&nx(s<c?n:r,s,l,c,s<c?r:n,s,t.x,t.y)){let u=Math.abs(s-t.y)/(n-t.x);wl(t,i)&&(u<h||u===h&&(t.x>o.x||t.x===o.x&&Ww(o,t)))&&(o=t,h=u)}t=t.next}while(t!==a);return o}function Ww(i,e){return on(i.prev,i,e.prev)<0&&on(e.next,i,i.next)<0}function Xw(i,e,t,n){let s=i;do s.z===0&&(s.z=Qd(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,qw(s)}function qw(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let o=n,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,t*=2}while(e>1);return i}function Qd(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function $w(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function nx(i,e,t,n,s,r,o,a){return(s-o)*(e-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(n-a)}function Za(i,e,t,n,s,r,o,a){return!(i===o&&e===a)&&nx(i,e,t,n,s,r,o,a)}function Yw(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!jw(i,e)&&(wl(i,e)&&wl(e,i)&&Zw(i,e)&&(on(i.prev,i,e.prev)||on(i,e.prev,e))||ia(i,e)&&on(i.prev,i,i.next)>0&&on(e.prev,e,e.next)>0)}function on(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function ia(i,e){return i.x===e.x&&i.y===e.y}function ix(i,e,t,n){let s=jc(on(i,e,t)),r=jc(on(i,e,n)),o=jc(on(t,n,i)),a=jc(on(t,n,e));return!!(s!==r&&o!==a||s===0&&Yc(i,t,e)||r===0&&Yc(i,n,e)||o===0&&Yc(t,i,n)||a===0&&Yc(t,e,n))}function Yc(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function jc(i){return i>0?1:i<0?-1:0}function jw(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&ix(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function wl(i,e){return on(i.prev,i,i.next)<0?on(i,e,i.next)>=0&&on(i,i.prev,e)>=0:on(i,e,i.prev)<0||on(i,i.next,e)<0}function Zw(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function sx(i,e){let t=ep(i.i,i.x,i.y),n=ep(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function sb(i,e,t,n){let s=ep(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function Sl(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function ep(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function Jw(i,e,t,n){let s=0;for(let r=e,o=t-n;r<t;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var tp=class{static triangulate(e,t,n=2){return Uw(e,t,n)}},Ms=class i{static area(e){let t=e.length,n=0;for(let s=t-1,r=0;r<t;s=r++)n+=e[s].x*e[r].y-e[r].x*e[s].y;return n*.5}static isClockWise(e){return i.area(e)<0}static triangulateShape(e,t){let n=[],s=[],r=[];rb(e),ob(n,e);let o=e.length;t.forEach(rb);for(let l=0;l<t.length;l++)s.push(o),o+=t[l].length,ob(n,t[l]);let a=tp.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function rb(i){let e=i.length;e>2&&i[e-1].equals(i[0])&&i.pop()}function ob(i,e){for(let t=0;t<e.length;t++)i.push(e[t].x),i.push(e[t].y)}var Ml=class i extends vh{constructor(e=1,t=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new i(e.radius,e.detail)}},El=class i extends gt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,f=t/l,d=[],p=[],b=[],m=[];for(let g=0;g<h;g++){let x=g*f-o;for(let _=0;_<c;_++){let y=_*u-r;p.push(y,-x,0),b.push(0,0,1),m.push(_/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let _=x+c*g,y=x+c*(g+1),T=x+1+c*(g+1),M=x+1+c*g;d.push(_,y,M),d.push(y,T,M)}this.setIndex(d),this.setAttribute("position",new Ke(p,3)),this.setAttribute("normal",new Ke(b,3)),this.setAttribute("uv",new Ke(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Tl=class i extends gt{constructor(e=new na([new we(0,.5),new we(-.5,-.5),new we(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let n=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let h=0;h<e.length;h++)c(e[h]),this.addGroup(a,l,h),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new Ke(s,3)),this.setAttribute("normal",new Ke(r,3)),this.setAttribute("uv",new Ke(o,2));function c(h){let u=s.length/3,f=h.extractPoints(t),d=f.shape,p=f.holes;Ms.isClockWise(d)===!1&&(d=d.reverse());for(let m=0,g=p.length;m<g;m++){let x=p[m];Ms.isClockWise(x)===!0&&(p[m]=x.reverse())}let b=Ms.triangulateShape(d,p);for(let m=0,g=p.length;m<g;m++){let x=p[m];d=d.concat(x)}for(let m=0,g=d.length;m<g;m++){let x=d[m];s.push(x.x,x.y,0),r.push(0,0,1),o.push(x.x,x.y)}for(let m=0,g=b.length;m<g;m++){let x=b[m],_=x[0]+u,y=x[1]+u,T=x[2]+u;n.push(_,y,T),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return Kw(t,e)}static fromJSON(e,t){let n=[];for(let s=0,r=e.shapes.length;s<r;s++){let o=t[e.shapes[s]];n.push(o)}return new i(n,e.curveSegments)}};function Kw(i,e){if(e.shapes=[],Array.isArray(i))for(let t=0,n=i.length;t<n;t++){let s=i[t];e.shapes.push(s.uuid)}else e.shapes.push(i.uuid);return e}var Al=class extends gt{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new I,r=new I;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let u=l[c],f=u.start,d=u.count;for(let p=f,b=f+d;p<b;p+=3)for(let m=0;m<3;m++){let g=a.getX(p+m),x=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,g),r.fromBufferAttribute(o,x),ab(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,u=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),ab(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Ke(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function ab(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}function io(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(lb(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(lb(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function si(i){let e={};for(let t=0;t<i.length;t++){let n=io(i[t]);for(let s in n)e[s]=n[s]}return e}function lb(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Qw(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Fp(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:yt.workingColorSpace}var ql={clone:io,merge:si},eS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,tS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,_i=class extends Es{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=eS,this.fragmentShader=tS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=io(e.uniforms),this.uniformsGroups=Qw(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Xe().setHex(s.value);break;case"v2":this.uniforms[n].value=new we().fromArray(s.value);break;case"v3":this.uniforms[n].value=new I().fromArray(s.value);break;case"v4":this.uniforms[n].value=new It().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Qe().fromArray(s.value);break;case"m4":this.uniforms[n].value=new xt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Eh=class extends _i{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var As=class extends Es{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Xe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Au,this.normalScale=new we(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Zs,this.combine=zh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Th=class extends Es{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Vb,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ah=class extends Es{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ho(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Zc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Pr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Rh=class extends Pr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:jd,endingEnd:jd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Zd:r=e,a=2*t-n;break;case Jd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Zd:o=e,l=2*n-t;break;case Jd:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,p=(n-t)/(s-t),b=p*p,m=b*p,g=-f*m+2*f*b-f*p,x=(1+f)*m+(-1.5-2*f)*b+(-.5+f)*p+1,_=(-1-d)*m+(1.5+d)*b+.5*p,y=d*m-d*b;for(let T=0;T!==a;++T)r[T]=g*o[h+T]+x*o[c+T]+_*o[l+T]+y*o[u+T];return r}},Ch=class extends Pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},Ph=class extends Pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Ih=class extends Pr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),b=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*b+o[l+m]*p;return r}let f=a*2,d=e-1;for(let p=0;p!==a;++p){let b=o[c+p],m=o[l+p],g=d*f+p*2,x=u[g],_=u[g+1],y=e*f+p*2,T=h[y],M=h[y+1],v=iS(n,t,x,T,s);r[p]=rx(v,b,_,M,m)}return r}};function rx(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function nS(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function iS(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=rx(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=nS(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ni=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ho(t,this.TimeBufferType),this.values=Ho(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ho(e.times,Array),values:Ho(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Zc(e.settings)&&(n.settings={inTangents:Ho(e.settings.inTangents,Array),outTangents:Ho(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ph(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Ch(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Rh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Ih(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case nl:t=this.InterpolantFactoryMethodDiscrete;break;case uh:t=this.InterpolantFactoryMethodLinear;break;case eh:t=this.InterpolantFactoryMethodSmooth;break;case Yd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ye("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return nl;case this.InterpolantFactoryMethodLinear:return uh;case this.InterpolantFactoryMethodSmooth:return eh;case this.InterpolantFactoryMethodBezier:return Yd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Zc(this.settings)&&(cb(this.settings.inTangents,e),cb(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Zc(this.settings)&&(hb(this.settings.inTangents,e),hb(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){nt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){nt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&$1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){nt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===eh,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,f=u-n,d=u+n;for(let p=0;p!==n;++p){let b=t[u+p];if(b!==t[f+p]||b!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,f=o*n;for(let d=0;d!==n;++d)t[f+d]=t[u+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Zc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function cb(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function hb(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Ni.prototype.ValueTypeName="";Ni.prototype.TimeBufferType=Float32Array;Ni.prototype.ValueBufferType=Float32Array;Ni.prototype.DefaultInterpolation=uh;var Ir=class extends Ni{constructor(e,t,n){super(e,t,n)}};Ir.prototype.ValueTypeName="bool";Ir.prototype.ValueBufferType=Array;Ir.prototype.DefaultInterpolation=nl;Ir.prototype.InterpolantFactoryMethodLinear=void 0;Ir.prototype.InterpolantFactoryMethodSmooth=void 0;var Lh=class extends Ni{constructor(e,t,n,s){super(e,t,n,s)}};Lh.prototype.ValueTypeName="color";var Dh=class extends Ni{constructor(e,t,n,s){super(e,t,n,s)}};Dh.prototype.ValueTypeName="number";var Nh=class extends Pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)mi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Rl=class extends Ni{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Nh(this.times,this.values,this.getValueSize(),e)}};Rl.prototype.ValueTypeName="quaternion";Rl.prototype.InterpolantFactoryMethodSmooth=void 0;var Lr=class extends Ni{constructor(e,t,n){super(e,t,n)}};Lr.prototype.ValueTypeName="string";Lr.prototype.ValueBufferType=Array;Lr.prototype.DefaultInterpolation=nl;Lr.prototype.InterpolantFactoryMethodLinear=void 0;Lr.prototype.InterpolantFactoryMethodSmooth=void 0;var Uh=class extends Ni{constructor(e,t,n,s){super(e,t,n,s)}};Uh.prototype.ValueTypeName="vector";var Fh=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],p=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},ox=new Fh,Oh=class{constructor(e){this.manager=e!==void 0?e:ox,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Oh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Cl=class extends nn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Xe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Pl=class extends Cl{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(nn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Xe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},qd=new xt,ub=new I,fb=new I,kh=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new we(512,512),this.mapType=wi,this.map=null,this.mapPass=null,this.matrix=new xt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Rr,this._frameExtents=new we(1,1),this._viewportCount=1,this._viewports=[new It(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;ub.setFromMatrixPosition(e.matrixWorld),t.position.copy(ub),fb.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(fb),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){qd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(qd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Yo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(qd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Jc=new I,Kc=new mi,ws=new I,Il=class extends nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new xt,this.projectionMatrix=new xt,this.projectionMatrixInverse=new xt,this.coordinateSystem=Xi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Jc,Kc,ws),ws.x===1&&ws.y===1&&ws.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Jc,Kc,ws.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Jc,Kc,ws),ws.x===1&&ws.y===1&&ws.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Jc,Kc,ws.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Tr=new I,db=new we,pb=new we,gn=class extends Il{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Zo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ka*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Zo*2*Math.atan(Math.tan(Ka*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Tr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Tr.x,Tr.y).multiplyScalar(-e/Tr.z),Tr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Tr.x,Tr.y).multiplyScalar(-e/Tr.z)}getViewSize(e,t){return this.getViewBounds(e,db,pb),t.subVectors(pb,db)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ka*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ui=class extends Il{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},np=class extends kh{constructor(){super(new Ui(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ll=class extends Cl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(nn.DEFAULT_UP),this.updateMatrix(),this.target=new nn,this.shadow=new np}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Dl=class extends gt{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Vo=-90,Go=1,sa=class extends nn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new gn(Vo,Go,e,t);s.layers=this.layers,this.add(s);let r=new gn(Vo,Go,e,t);r.layers=this.layers,this.add(r);let o=new gn(Vo,Go,e,t);o.layers=this.layers,this.add(o);let a=new gn(Vo,Go,e,t);a.layers=this.layers,this.add(a);let l=new gn(Vo,Go,e,t);l.layers=this.layers,this.add(l);let c=new gn(Vo,Go,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Xi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Yo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let b=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=b,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,f,d),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Bh=class extends gn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Op="\\[\\]\\.:\\/",sS=new RegExp("["+Op+"]","g"),kp="[^"+Op+"]",rS="[^"+Op.replace("\\.","")+"]",oS=/((?:WC+[\/:])*)/.source.replace("WC",kp),aS=/(WCOD+)?/.source.replace("WCOD",rS),lS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",kp),cS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",kp),hS=new RegExp("^"+oS+aS+lS+cS+"$"),uS=["material","materials","bones","map"],ip=class{constructor(e,t,n){let s=n||Kt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Kt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(sS,"")}static parseTrackName(e){let t=hS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);uS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Kt.Composite=ip;Kt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Kt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Kt.prototype.GetterByBindingType=[Kt.prototype._getValue_direct,Kt.prototype._getValue_array,Kt.prototype._getValue_arrayElement,Kt.prototype._getValue_toArray];Kt.prototype.SetterByBindingTypeAndVersioning=[[Kt.prototype._setValue_direct,Kt.prototype._setValue_direct_setNeedsUpdate,Kt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_array,Kt.prototype._setValue_array_setNeedsUpdate,Kt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_arrayElement,Kt.prototype._setValue_arrayElement_setNeedsUpdate,Kt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Kt.prototype._setValue_fromArray,Kt.prototype._setValue_fromArray_setNeedsUpdate,Kt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var wI=new Float32Array(1);var Dr=class extends mh{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var mb=new xt,Nl=class{constructor(e,t,n=0,s=1/0){this.ray=new Js(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Ko,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):nt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return mb.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(mb),this}intersectObject(e,t=!0,n=[]){return sp(e,this,n,t),n.sort(gb),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)sp(e[s],this,n,t);return n.sort(gb),n}};function gb(i,e){return i.distance-e.distance}function sp(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)sp(r[o],e,t,!0)}}var ra=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=rt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(rt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var rp=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var bb=new I,Qc=new I,Wo=new I,Xo=new I,$d=new I,fS=new I,dS=new I,Ul=class{constructor(e=new I,t=new I){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){bb.subVectors(e,this.start),Qc.subVectors(this.end,this.start);let n=Qc.dot(Qc);if(n===0)return 0;let r=Qc.dot(bb)/n;return t&&(r=rt(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=fS,n=dS){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,h=e.end;Wo.subVectors(c,a),Xo.subVectors(h,l),$d.subVectors(a,l);let u=Wo.dot(Wo),f=Xo.dot(Xo),d=Xo.dot($d);if(u<=s&&f<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(u<=s)r=0,o=d/f,o=rt(o,0,1);else{let p=Wo.dot($d);if(f<=s)o=0,r=rt(-p/u,0,1);else{let b=Wo.dot(Xo),m=u*f-b*b;m!==0?r=rt((b*d-p*f)/m,0,1):r=0,o=(b*r+d)/f,o<0?(o=0,r=rt(-p/u,0,1)):o>1&&(o=1,r=rt((b-p)/u,0,1))}}return t.copy(a).addScaledVector(Wo,r),n.copy(l).addScaledVector(Xo,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Fl=class extends ss{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Bp(i,e,t,n){let s=pS(n);switch(t){case Mp:return i*e;case $h:return i*e/s.components*s.byteLength;case Yh:return i*e/s.components*s.byteLength;case Nr:return i*e*2/s.components*s.byteLength;case jh:return i*e*2/s.components*s.byteLength;case Ep:return i*e*3/s.components*s.byteLength;case cs:return i*e*4/s.components*s.byteLength;case Zh:return i*e*4/s.components*s.byteLength;case Bl:case zl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Hl:case Vl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Kh:case eu:return Math.max(i,16)*Math.max(e,8)/4;case Jh:case Qh:return Math.max(i,8)*Math.max(e,8)/2;case tu:case nu:case su:case ru:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case iu:case Gl:case ou:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case au:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case lu:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case cu:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case hu:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case uu:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case fu:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case du:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case pu:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case mu:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case gu:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case bu:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case xu:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case vu:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case yu:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case _u:case wu:case Su:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Mu:case Eu:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Wl:case Tu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function pS(i){switch(i){case wi:case yp:return{byteLength:1,components:1};case ca:case _p:case ls:return{byteLength:2,components:1};case Xh:case qh:return{byteLength:2,components:4};case Fi:case Wh:case Yi:return{byteLength:4,components:1};case wp:case Sp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Rx(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function gS(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((d,p)=>d.start-p.start);let f=0;for(let d=1;d<u.length;d++){let p=u[f],b=u[d];b.start<=p.start+p.count+1?p.count=Math.max(p.count,b.start+b.count-p.start):(++f,u[f]=b)}u.length=f+1;for(let d=0,p=u.length;d<p;d++){let b=u[d];i.bufferSubData(c,b.start*h.BYTES_PER_ELEMENT,h,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var bS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,xS=`#ifdef USE_ALPHAHASH
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
#endif`,vS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,yS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,_S=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,wS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,SS=`#ifdef USE_AOMAP
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
#endif`,MS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,ES=`#ifdef USE_BATCHING
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
#endif`,TS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,AS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,RS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,CS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,PS=`#ifdef USE_IRIDESCENCE
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
#endif`,IS=`#ifdef USE_BUMPMAP
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
#endif`,LS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,DS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,NS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,US=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,FS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,OS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,kS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,BS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,zS=`#define PI 3.141592653589793
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
} // validated`,HS=`vec3 transformedNormal = objectNormal;
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
#endif`,VS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,GS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,WS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,XS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,qS="gl_FragColor = linearToOutputTexel( gl_FragColor );",$S=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,YS=`#ifdef USE_ENVMAP
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
#endif`,jS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ZS=`#ifdef USE_ENVMAP
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
#endif`,JS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,KS=`#ifdef USE_ENVMAP
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
#endif`,QS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,eM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,tM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,nM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,iM=`#ifdef USE_GRADIENTMAP
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
}`,sM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,rM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,oM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,aM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,lM=`#ifdef USE_ENVMAP
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
#endif`,cM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,hM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,uM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,fM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,dM=`PhysicalMaterial material;
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
#endif`,pM=`uniform sampler2D dfgLUT;
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
}`,mM=`
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
#endif`,gM=`#if defined( RE_IndirectDiffuse )
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
#endif`,bM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,xM=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,vM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,yM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,_M=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,wM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,SM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,MM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,EM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,TM=`#if defined( USE_POINTS_UV )
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
#endif`,AM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,RM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,CM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,PM=`#if defined( USE_MORPHCOLORS )
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
#endif`,IM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,LM=`#ifdef USE_MORPHTARGETS
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
#endif`,DM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,NM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,UM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,FM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,OM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,kM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,BM=`#ifdef USE_NORMALMAP
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
#endif`,zM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,HM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,VM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,GM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,WM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,XM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,qM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,$M=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,YM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,jM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ZM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,JM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,KM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,QM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,eE=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,tE=`float getShadowMask() {
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
}`,nE=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,iE=`#ifdef USE_SKINNING
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
#endif`,sE=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,rE=`#ifdef USE_SKINNING
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
#endif`,oE=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,aE=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,lE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,cE=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,hE=`#ifdef USE_TRANSMISSION
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
#endif`,uE=`#ifdef USE_TRANSMISSION
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
#endif`,fE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,dE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,gE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,bE=`uniform sampler2D t2D;
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
}`,xE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vE=`uniform float backgroundBlurriness;
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
}`,yE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,_E=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wE=`#include <common>
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
}`,SE=`#if DEPTH_PACKING == 3200
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
}`,ME=`#define DISTANCE
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
}`,EE=`#define DISTANCE
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
}`,TE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,AE=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,RE=`uniform float scale;
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
}`,CE=`uniform vec3 diffuse;
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
}`,PE=`#include <common>
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
}`,IE=`uniform vec3 diffuse;
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
}`,LE=`#define LAMBERT
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
}`,DE=`#define LAMBERT
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
}`,NE=`#define MATCAP
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
}`,UE=`#define MATCAP
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
}`,FE=`#define NORMAL
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
}`,OE=`#define NORMAL
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
}`,kE=`#define PHONG
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
}`,BE=`#define PHONG
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
}`,zE=`#define STANDARD
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
}`,HE=`#define STANDARD
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
}`,VE=`#define TOON
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
}`,GE=`#define TOON
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
}`,WE=`uniform float size;
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
}`,XE=`uniform vec3 diffuse;
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
}`,qE=`#include <common>
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
}`,$E=`uniform vec3 color;
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
}`,YE=`uniform float rotation;
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
}`,jE=`uniform vec3 diffuse;
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
}`,dt={alphahash_fragment:bS,alphahash_pars_fragment:xS,alphamap_fragment:vS,alphamap_pars_fragment:yS,alphatest_fragment:_S,alphatest_pars_fragment:wS,aomap_fragment:SS,aomap_pars_fragment:MS,batching_pars_vertex:ES,batching_vertex:TS,begin_vertex:AS,beginnormal_vertex:RS,bsdfs:CS,iridescence_fragment:PS,bumpmap_pars_fragment:IS,clipping_planes_fragment:LS,clipping_planes_pars_fragment:DS,clipping_planes_pars_vertex:NS,clipping_planes_vertex:US,color_fragment:FS,color_pars_fragment:OS,color_pars_vertex:kS,color_vertex:BS,common:zS,defaultnormal_vertex:HS,displacementmap_pars_vertex:VS,displacementmap_vertex:GS,emissivemap_fragment:WS,emissivemap_pars_fragment:XS,colorspace_fragment:qS,colorspace_pars_fragment:$S,envmap_fragment:YS,envmap_common_pars_fragment:jS,envmap_pars_fragment:ZS,envmap_pars_vertex:JS,envmap_physical_pars_fragment:lM,envmap_vertex:KS,fog_vertex:QS,fog_pars_vertex:eM,fog_fragment:tM,fog_pars_fragment:nM,gradientmap_pars_fragment:iM,lightmap_pars_fragment:sM,lights_lambert_fragment:rM,lights_lambert_pars_fragment:oM,lights_pars_begin:aM,lights_toon_fragment:cM,lights_toon_pars_fragment:hM,lights_phong_fragment:uM,lights_phong_pars_fragment:fM,lights_physical_fragment:dM,lights_physical_pars_fragment:pM,lights_fragment_begin:mM,lights_fragment_maps:gM,lights_fragment_end:bM,lightprobes_pars_fragment:xM,logdepthbuf_fragment:vM,logdepthbuf_pars_fragment:yM,logdepthbuf_pars_vertex:_M,logdepthbuf_vertex:wM,map_fragment:SM,map_pars_fragment:MM,map_particle_fragment:EM,map_particle_pars_fragment:TM,metalnessmap_fragment:AM,metalnessmap_pars_fragment:RM,morphinstance_vertex:CM,morphcolor_vertex:PM,morphnormal_vertex:IM,morphtarget_pars_vertex:LM,morphtarget_vertex:DM,normal_fragment_begin:NM,normal_fragment_maps:UM,normal_pars_fragment:FM,normal_pars_vertex:OM,normal_vertex:kM,normalmap_pars_fragment:BM,clearcoat_normal_fragment_begin:zM,clearcoat_normal_fragment_maps:HM,clearcoat_pars_fragment:VM,iridescence_pars_fragment:GM,opaque_fragment:WM,packing:XM,premultiplied_alpha_fragment:qM,project_vertex:$M,dithering_fragment:YM,dithering_pars_fragment:jM,roughnessmap_fragment:ZM,roughnessmap_pars_fragment:JM,shadowmap_pars_fragment:KM,shadowmap_pars_vertex:QM,shadowmap_vertex:eE,shadowmask_pars_fragment:tE,skinbase_vertex:nE,skinning_pars_vertex:iE,skinning_vertex:sE,skinnormal_vertex:rE,specularmap_fragment:oE,specularmap_pars_fragment:aE,tonemapping_fragment:lE,tonemapping_pars_fragment:cE,transmission_fragment:hE,transmission_pars_fragment:uE,uv_pars_fragment:fE,uv_pars_vertex:dE,uv_vertex:pE,worldpos_vertex:mE,background_vert:gE,background_frag:bE,backgroundCube_vert:xE,backgroundCube_frag:vE,cube_vert:yE,cube_frag:_E,depth_vert:wE,depth_frag:SE,distance_vert:ME,distance_frag:EE,equirect_vert:TE,equirect_frag:AE,linedashed_vert:RE,linedashed_frag:CE,meshbasic_vert:PE,meshbasic_frag:IE,meshlambert_vert:LE,meshlambert_frag:DE,meshmatcap_vert:NE,meshmatcap_frag:UE,meshnormal_vert:FE,meshnormal_frag:OE,meshphong_vert:kE,meshphong_frag:BE,meshphysical_vert:zE,meshphysical_frag:HE,meshtoon_vert:VE,meshtoon_frag:GE,points_vert:WE,points_frag:XE,shadow_vert:qE,shadow_frag:$E,sprite_vert:YE,sprite_frag:jE},Ie={common:{diffuse:{value:new Xe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Qe},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Qe}},envmap:{envMap:{value:null},envMapRotation:{value:new Qe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Qe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qe},normalScale:{value:new we(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Xe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Xe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0},uvTransform:{value:new Qe}},sprite:{diffuse:{value:new Xe(16777215)},opacity:{value:1},center:{value:new we(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qe},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0}}},bi={basic:{uniforms:si([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.fog]),vertexShader:dt.meshbasic_vert,fragmentShader:dt.meshbasic_frag},lambert:{uniforms:si([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new Xe(0)},envMapIntensity:{value:1}}]),vertexShader:dt.meshlambert_vert,fragmentShader:dt.meshlambert_frag},phong:{uniforms:si([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new Xe(0)},specular:{value:new Xe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:dt.meshphong_vert,fragmentShader:dt.meshphong_frag},standard:{uniforms:si([Ie.common,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.roughnessmap,Ie.metalnessmap,Ie.fog,Ie.lights,{emissive:{value:new Xe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag},toon:{uniforms:si([Ie.common,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.gradientmap,Ie.fog,Ie.lights,{emissive:{value:new Xe(0)}}]),vertexShader:dt.meshtoon_vert,fragmentShader:dt.meshtoon_frag},matcap:{uniforms:si([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,{matcap:{value:null}}]),vertexShader:dt.meshmatcap_vert,fragmentShader:dt.meshmatcap_frag},points:{uniforms:si([Ie.points,Ie.fog]),vertexShader:dt.points_vert,fragmentShader:dt.points_frag},dashed:{uniforms:si([Ie.common,Ie.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:dt.linedashed_vert,fragmentShader:dt.linedashed_frag},depth:{uniforms:si([Ie.common,Ie.displacementmap]),vertexShader:dt.depth_vert,fragmentShader:dt.depth_frag},normal:{uniforms:si([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,{opacity:{value:1}}]),vertexShader:dt.meshnormal_vert,fragmentShader:dt.meshnormal_frag},sprite:{uniforms:si([Ie.sprite,Ie.fog]),vertexShader:dt.sprite_vert,fragmentShader:dt.sprite_frag},background:{uniforms:{uvTransform:{value:new Qe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:dt.background_vert,fragmentShader:dt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qe}},vertexShader:dt.backgroundCube_vert,fragmentShader:dt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:dt.cube_vert,fragmentShader:dt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:dt.equirect_vert,fragmentShader:dt.equirect_frag},distance:{uniforms:si([Ie.common,Ie.displacementmap,{referencePosition:{value:new I},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:dt.distance_vert,fragmentShader:dt.distance_frag},shadow:{uniforms:si([Ie.lights,Ie.fog,{color:{value:new Xe(0)},opacity:{value:1}}]),vertexShader:dt.shadow_vert,fragmentShader:dt.shadow_frag}};bi.physical={uniforms:si([bi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qe},clearcoatNormalScale:{value:new we(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Qe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Qe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Qe},sheen:{value:0},sheenColor:{value:new Xe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Qe},transmissionSamplerSize:{value:new we},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qe},attenuationDistance:{value:0},attenuationColor:{value:new Xe(0)},specularColor:{value:new Xe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qe},anisotropyVector:{value:new we},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Qe}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag};var Cu={r:0,b:0,g:0},ZE=new xt,Cx=new Qe;Cx.set(-1,0,0,0,1,0,0,0,1);function JE(i,e,t,n,s,r){let o=new Xe(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(x){let _=x.isScene===!0?x.background:null;if(_&&_.isTexture){let y=x.backgroundBlurriness>0;_=e.get(_,y)}return _}function p(x){let _=!1,y=d(x);y===null?m(o,a):y&&y.isColor&&(m(y,1),_=!0);let T=i.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||_)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function b(x,_){let y=d(_);y&&y.isCubeTexture?(c===void 0&&(c=new Lt(new Cr(1,1,1),new _i({name:"BackgroundCubeMaterial",uniforms:io(bi.backgroundCube.uniforms),vertexShader:bi.backgroundCube.vertexShader,fragmentShader:bi.backgroundCube.fragmentShader,side:gi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,M,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=_.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(ZE.makeRotationFromEuler(_.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Cx),c.material.toneMapped=yt.getTransfer(y.colorSpace)!==Pt,(h!==y||u!==y.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=y,u=y.version,f=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new Lt(new El(2,2),new _i({name:"BackgroundMaterial",uniforms:io(bi.background.uniforms),vertexShader:bi.background.vertexShader,fragmentShader:bi.background.fragmentShader,side:Rs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,l.material.toneMapped=yt.getTransfer(y.colorSpace)!==Pt,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(h!==y||u!==y.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=y,u=y.version,f=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,_){x.getRGB(Cu,Fp(i)),t.buffers.color.setClear(Cu.r,Cu.g,Cu.b,_,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,_=1){o.set(x),a=_,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:b,dispose:g}}function KE(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(L,O,z,U,G){let q=!1,H=u(L,U,z,O);r!==H&&(r=H,c(r.object)),q=d(L,U,z,G),q&&p(L,U,z,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,y(L,O,z,U),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,O,z,U){let G=U.wireframe===!0,q=n[O.id];q===void 0&&(q={},n[O.id]=q);let H=L.isInstancedMesh===!0?L.id:0,ae=q[H];ae===void 0&&(ae={},q[H]=ae);let Y=ae[z.id];Y===void 0&&(Y={},ae[z.id]=Y);let ee=Y[G];return ee===void 0&&(ee=f(l()),Y[G]=ee),ee}function f(L){let O=[],z=[],U=[];for(let G=0;G<t;G++)O[G]=0,z[G]=0,U[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:z,attributeDivisors:U,object:L,attributes:{},index:null}}function d(L,O,z,U){let G=r.attributes,q=O.attributes,H=0,ae=z.getAttributes();for(let Y in ae)if(ae[Y].location>=0){let te=G[Y],de=q[Y];if(de===void 0&&(Y==="instanceMatrix"&&L.instanceMatrix&&(de=L.instanceMatrix),Y==="instanceColor"&&L.instanceColor&&(de=L.instanceColor)),te===void 0||te.attribute!==de||de&&te.data!==de.data)return!0;H++}return r.attributesNum!==H||r.index!==U}function p(L,O,z,U){let G={},q=O.attributes,H=0,ae=z.getAttributes();for(let Y in ae)if(ae[Y].location>=0){let te=q[Y];te===void 0&&(Y==="instanceMatrix"&&L.instanceMatrix&&(te=L.instanceMatrix),Y==="instanceColor"&&L.instanceColor&&(te=L.instanceColor));let de={};de.attribute=te,te&&te.data&&(de.data=te.data),G[Y]=de,H++}r.attributes=G,r.attributesNum=H,r.index=U}function b(){let L=r.newAttributes;for(let O=0,z=L.length;O<z;O++)L[O]=0}function m(L){g(L,0)}function g(L,O){let z=r.newAttributes,U=r.enabledAttributes,G=r.attributeDivisors;z[L]=1,U[L]===0&&(i.enableVertexAttribArray(L),U[L]=1),G[L]!==O&&(i.vertexAttribDivisor(L,O),G[L]=O)}function x(){let L=r.newAttributes,O=r.enabledAttributes;for(let z=0,U=O.length;z<U;z++)O[z]!==L[z]&&(i.disableVertexAttribArray(z),O[z]=0)}function _(L,O,z,U,G,q,H){H===!0?i.vertexAttribIPointer(L,O,z,G,q):i.vertexAttribPointer(L,O,z,U,G,q)}function y(L,O,z,U){b();let G=U.attributes,q=z.getAttributes(),H=O.defaultAttributeValues;for(let ae in q){let Y=q[ae];if(Y.location>=0){let ee=G[ae];if(ee===void 0&&(ae==="instanceMatrix"&&L.instanceMatrix&&(ee=L.instanceMatrix),ae==="instanceColor"&&L.instanceColor&&(ee=L.instanceColor)),ee!==void 0){let te=ee.normalized,de=ee.itemSize,ce=e.get(ee);if(ce===void 0)continue;let K=ce.buffer,ue=ce.type,ge=ce.bytesPerElement,Me=ue===i.INT||ue===i.UNSIGNED_INT||ee.gpuType===Wh;if(ee.isInterleavedBufferAttribute){let xe=ee.data,Ge=xe.isInterleavedBuffer===!0?xe.stride:xe.itemSize,it=ee.offset;if(xe.isInstancedInterleavedBuffer||xe.isInstancedBufferAttribute){for(let He=0;He<Y.locationSize;He++)g(Y.location+He,xe.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=xe.meshPerAttribute*xe.count)}else for(let He=0;He<Y.locationSize;He++)m(Y.location+He);i.bindBuffer(i.ARRAY_BUFFER,K);for(let He=0;He<Y.locationSize;He++)_(Y.location+He,de/Y.locationSize,ue,te,Ge*ge,(it+de/Y.locationSize*He)*ge,Me)}else{if(ee.isInstancedBufferAttribute){for(let xe=0;xe<Y.locationSize;xe++)g(Y.location+xe,ee.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let xe=0;xe<Y.locationSize;xe++)m(Y.location+xe);i.bindBuffer(i.ARRAY_BUFFER,K);for(let xe=0;xe<Y.locationSize;xe++)_(Y.location+xe,de/Y.locationSize,ue,te,de*ge,de/Y.locationSize*xe*ge,Me)}}else if(H!==void 0){let te=H[ae];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(Y.location,te);break;case 3:i.vertexAttrib3fv(Y.location,te);break;case 4:i.vertexAttrib4fv(Y.location,te);break;default:i.vertexAttrib1fv(Y.location,te)}}}}x()}function T(){C();for(let L in n){let O=n[L];for(let z in O){let U=O[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete n[L]}}function M(L){if(n[L.id]===void 0)return;let O=n[L.id];for(let z in O){let U=O[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete n[L.id]}function v(L){for(let O in n){let z=n[O];for(let U in z){let G=z[U];if(G[L.id]===void 0)continue;let q=G[L.id];for(let H in q)h(q[H].object),delete q[H];delete G[L.id]}}}function S(L){for(let O in n){let z=n[O],U=L.isInstancedMesh===!0?L.id:0,G=z[U];if(G!==void 0){for(let q in G){let H=G[q];for(let ae in H)h(H[ae].object),delete H[ae];delete G[q]}delete z[U],Object.keys(z).length===0&&delete n[O]}}}function C(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:C,resetDefaultState:P,dispose:T,releaseStatesOfGeometry:M,releaseStatesOfObject:S,releaseStatesOfProgram:v,initAttributes:b,enableAttribute:m,disableUnusedAttributes:x}}function QE(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];t.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function eT(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==cs&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let S=v===ls&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==wi&&v!==Yi&&!S&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ye("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),_=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),T=i.getParameter(i.MAX_SAMPLES),M=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:p,maxTextureSize:b,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:x,maxVaryings:_,maxFragmentUniforms:y,maxSamples:T,samples:M}}function tT(i){let e=this,t=null,n=0,s=!1,r=!1,o=new di,a=new Qe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){t=h(u,f,0)},this.setState=function(u,f,d){let p=u.clippingPlanes,b=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let x=r?0:n,_=x*4,y=g.clippingState||null;l.value=y,y=h(p,f,_,d);for(let T=0;T!==_;++T)y[T]=t[T];g.clippingState=y,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,f,d,p){let b=u!==null?u.length:0,m=null;if(b!==0){if(m=l.value,p!==!0||m===null){let g=d+b*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<g)&&(m=new Float32Array(g));for(let _=0,y=d;_!==b;++_,y+=4)o.copy(u[_]).applyMatrix4(x,a),o.normal.toArray(m,y),m[y+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,m}}var jl=class extends $n{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new fl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Cr(5,5,5),r=new _i({name:"CubemapFromEquirect",uniforms:io(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:gi,blending:ir});r.uniforms.tEquirect.value=t;let o=new Lt(s,r),a=t.minFilter;return t.minFilter===sr&&(t.minFilter=pi),new sa(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},ax=256,nT=3,iT=20,Px=256,Ix=16,sT=3,rT=new I,oT=new Xe,Iu=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new sa(1,10,null),this._boxMesh=new Lt(new Cr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=rT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(oT));let m=new sa(n,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=p,e.background=b,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=hx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=cx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(ax,Lp(e))}_fromTexture(e,t){e.mapping===to||e.mapping===la?this._setSize(e.image.length===0?ax:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=lx(e,!1,!1),n=Math.log2(e)-nT;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=lx(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===to||e.mapping===la?(this._cubemapMaterial===null&&(this._cubemapMaterial=hx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=cx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=aT(),this._integrationMaterial=lT());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Ix);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-sT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Px*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=cT());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function lx(i,e,t){return new jl(i,{minFilter:sr,generateMipmaps:e,type:ls,colorSpace:il,depthBuffer:t})}function Zl(i,e,t){return new _i({name:i,uniforms:e,vertexShader:dt.cube_vert,fragmentShader:t,side:gi,blending:ir,depthTest:!1,depthWrite:!1})}function aT(){return Zl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Px}u

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
	`)}function lT(){return Zl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ix}},`

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
	`)}function cT(){return Zl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${iT}
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
	`)}function cx(){return Zl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function hx(){return Zl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function hT(i){let e=new WeakMap,t=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Hh||d===Vh)if(e.has(f)){let p=e.get(f).texture;return a(p,f.mapping)}else{let p=f.image;if(p&&p.height>0){let b=new jl(p.height);return b.fromEquirectangularTexture(i,f),e.set(f,b),f.addEventListener("dispose",c),a(b.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,p=d===Hh||d===Vh,b=d===to||d===la;if(p||b){let m=t.get(f),g=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return n===null&&(n=new Iu(i)),m=p?n.fromEquirectangular(f,m):n.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),m.texture;if(m!==void 0)return m.texture;{let x=f.image;return p&&x&&x.height>0||b&&x&&l(x)?(n===null&&(n=new Iu(i)),m=p?n.fromEquirectangular(f):n.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),f.addEventListener("dispose",h),m.texture):null}}}return f}function a(f,d){return d===Hh?f.mapping=to:d===Vh&&(f.mapping=la),f}function l(f){let d=0,p=6;for(let b=0;b<p;b++)f[b]!==void 0&&d++;return d===p}function c(f){let d=f.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function uT(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ja("WebGLRenderer: "+n+" extension not supported."),s}}}function fT(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let b=r.get(p);b&&(e.remove(b),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,b){return s[b.id]!==void 0||(b.addEventListener("dispose",a),s[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function h(p){let b=p.attributes;for(let m in b)e.update(b[m],i.ARRAY_BUFFER)}function u(p){let b=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let x=b!==null?b.array.length:m.array.length/3-1,_=m.count>=65535?hl:cl,y=new _(Math.ceil(x/3)*6,1),T=y.array;if(b!==null){let v=b.array;g=b.version;for(let S=0,C=0;S<x;S+=3){let P=v[S+0],L=v[S+1],O=v[S+2];T[C++]=P,T[C++]=L,T[C++]=L,T[C++]=O,T[C++]=O,T[C++]=P}}else{g=m.version;for(let v=0,S=0;v<x;v+=3){let C=v+0,P=v+1,L=v+2;T[S++]=C,T[S++]=P,T[S++]=P,T[S++]=L,T[S++]=L,T[S++]=C}}y.version=g;let M=r.get(p);M&&e.remove(M),r.set(p,y)}function f(p){let b=r.get(p);if(b){let m=p.index;m!==null&&b.version<m.version&&u(p)}else u(p);return r.get(p)}function d(){for(let p in s){let b=s[p].deref();b!==void 0&&l(b)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function dT(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),t.update(f,n,1)}function c(u,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,u*o,d),t.update(f,n,d))}function h(u,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,d);let b=0;for(let m=0;m<d;m++)b+=f[m];t.update(b,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function pT(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function mT(i,e,t){let n=new WeakMap,s=new It;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let C=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",C)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],_=0;d===!0&&(_=1),p===!0&&(_=2),b===!0&&(_=3);let y=a.attributes.position.count*_,T=1;y>e.maxTextureSize&&(T=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let M=new Float32Array(y*T*4*u),v=new al(M,y,T,u);v.type=Yi,v.needsUpdate=!0;let S=_*4;for(let P=0;P<u;P++){let L=m[P],O=g[P],z=x[P],U=y*T*4*P;for(let G=0;G<L.count;G++){let q=G*S;d===!0&&(s.fromBufferAttribute(L,G),M[U+q+0]=s.x,M[U+q+1]=s.y,M[U+q+2]=s.z,M[U+q+3]=0),p===!0&&(s.fromBufferAttribute(O,G),M[U+q+4]=s.x,M[U+q+5]=s.y,M[U+q+6]=s.z,M[U+q+7]=0),b===!0&&(s.fromBufferAttribute(z,G),M[U+q+8]=s.x,M[U+q+9]=s.y,M[U+q+10]=s.z,M[U+q+11]=z.itemSize===4?s.w:1)}}f={count:u,texture:v,size:new we(y,T)},n.set(a,f),a.addEventListener("dispose",C)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let d=0;for(let b=0;b<c.length;b++)d+=c[b];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function gT(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=e.get(c,u);if(r.get(f)!==h&&(e.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var bT={[fp]:"LINEAR_TONE_MAPPING",[dp]:"REINHARD_TONE_MAPPING",[pp]:"CINEON_TONE_MAPPING",[mp]:"ACES_FILMIC_TONE_MAPPING",[bp]:"AGX_TONE_MAPPING",[xp]:"NEUTRAL_TONE_MAPPING",[gp]:"CUSTOM_TONE_MAPPING"};function xT(i,e,t,n,s,r){let o=new $n(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new gt;h.setAttribute("position",new Ke([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ke([0,2,0,0,2,0],2));let u=new Eh({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Lt(h,u),d=new Ui(-1,1,1,-1,0,1),p=null,b=null,m=!1,g,x=null,_=[],y=!1;this.setSize=function(T,M){o.setSize(T,M),a!==null&&a.setSize(T,M),l!==null&&l.setSize(T,M);for(let v=0;v<_.length;v++){let S=_[v];S.setSize&&S.setSize(T,M)}},this.setEffects=function(T){_=T,y=_.length>0&&_[0].isRenderPass===!0;let M=o.width,v=o.height;_.length>0&&a===null&&(a=new $n(M,v,{type:ls,depthBuffer:!1,stencilBuffer:!1}),l=new $n(M,v,{type:ls,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&_.some(C=>C.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new os(M,v),r===!0&&(c.format=rr,c.type=no)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let C=0;C<_.length;C++){let P=_[C];P.setSize&&P.setSize(M,v),S&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(T,M){if(m||T.toneMapping===Cs&&_.length===0)return!1;if(x=M,M!==null){let v=M.width,S=M.height;(o.width!==v||o.height!==S)&&this.setSize(v,S)}return y===!1&&T.setRenderTarget(o),g=T.toneMapping,T.toneMapping=Cs,!0},this.hasRenderPass=function(){return y},this.end=function(T,M){T.toneMapping=g,m=!0;let v=o,S=a;for(let C=0;C<_.length;C++){let P=_[C];P.enabled!==!1&&(P.render(T,S,v,M),P.needsSwap!==!1&&(v=S,S=S===a?l:a))}if(p!==T.outputColorSpace||b!==T.toneMapping){p=T.outputColorSpace,b=T.toneMapping,u.defines={},yt.getTransfer(p)===Pt&&(u.defines.SRGB_TRANSFER="");let C=bT[b];C&&(u.defines[C]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,T.setRenderTarget(x),T.render(f,d),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Lx=new yi,Dx=new os(1,1),Nx=new dl(1),Ux=new al,Fx=new ph,Ox=new fl,ux=[],fx=[],dx=new Float32Array(16),px=new Float32Array(9),mx=new Float32Array(4);function ua(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=ux[s];if(r===void 0&&(r=new Float32Array(s),ux[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Cn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Pn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Du(i,e){let t=fx[e];t===void 0&&(t=new Int32Array(e),fx[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function vT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function yT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2fv(this.addr,e),Pn(t,e)}}function _T(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Cn(t,e))return;i.uniform3fv(this.addr,e),Pn(t,e)}}function wT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4fv(this.addr,e),Pn(t,e)}}function ST(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Pn(t,e)}else{if(Cn(t,n))return;mx.set(n),i.uniformMatrix2fv(this.addr,!1,mx),Pn(t,n)}}function MT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Pn(t,e)}else{if(Cn(t,n))return;px.set(n),i.uniformMatrix3fv(this.addr,!1,px),Pn(t,n)}}function ET(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Pn(t,e)}else{if(Cn(t,n))return;dx.set(n),i.uniformMatrix4fv(this.addr,!1,dx),Pn(t,n)}}function TT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function AT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2iv(this.addr,e),Pn(t,e)}}function RT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;i.uniform3iv(this.addr,e),Pn(t,e)}}function CT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4iv(this.addr,e),Pn(t,e)}}function PT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function IT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2uiv(this.addr,e),Pn(t,e)}}function LT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;i.uniform3uiv(this.addr,e),Pn(t,e)}}function DT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4uiv(this.addr,e),Pn(t,e)}}function Nu(i){return i.version===0&&(i.compareFunction=Rp,i.needsUpdate=!0),i}function NT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Nu(Dx):r=Lx,t.setTexture2D(e||r,s)}function UT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Fx,s)}function FT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Nu(Nx):r=Ox,t.setTextureCube(e||r,s)}function OT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Ux,s)}function kT(i){switch(i){case 5126:return vT;case 35664:return yT;case 35665:return _T;case 35666:return wT;case 35674:return ST;case 35675:return MT;case 35676:return ET;case 5124:case 35670:return TT;case 35667:case 35671:return AT;case 35668:case 35672:return RT;case 35669:case 35673:return CT;case 5125:return PT;case 36294:return IT;case 36295:return LT;case 36296:return DT;case 35678:case 36198:case 36298:case 36306:case 35682:return NT;case 35679:case 36299:case 36307:return UT;case 35680:case 36300:case 36308:case 36293:return FT;case 36289:case 36303:case 36311:case 36292:return OT}}function BT(i,e){i.uniform1fv(this.addr,e)}function zT(i,e){let t=ua(e,this.size,2);i.uniform2fv(this.addr,t)}function HT(i,e){let t=ua(e,this.size,3);i.uniform3fv(this.addr,t)}function VT(i,e){let t=ua(e,this.size,4);i.uniform4fv(this.addr,t)}function GT(i,e){let t=ua(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function WT(i,e){let t=ua(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function XT(i,e){let t=ua(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function qT(i,e){i.uniform1iv(this.addr,e)}function $T(i,e){i.uniform2iv(this.addr,e)}function YT(i,e){i.uniform3iv(this.addr,e)}function jT(i,e){i.uniform4iv(this.addr,e)}function ZT(i,e){i.uniform1uiv(this.addr,e)}function JT(i,e){i.uniform2uiv(this.addr,e)}function KT(i,e){i.uniform3uiv(this.addr,e)}function QT(i,e){i.uniform4uiv(this.addr,e)}function eA(i,e,t){let n=this.cache,s=e.length,r=Du(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Nu(Dx):o=Lx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function tA(i,e,t){let n=this.cache,s=e.length,r=Du(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Fx,r[o])}function nA(i,e,t){let n=this.cache,s=e.length,r=Du(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Nu(Nx):o=Ox;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function iA(i,e,t){let n=this.cache,s=e.length,r=Du(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Ux,r[o])}function sA(i){switch(i){case 5126:return BT;case 35664:return zT;case 35665:return HT;case 35666:return VT;case 35674:return GT;case 35675:return WT;case 35676:return XT;case 5124:case 35670:return qT;case 35667:case 35671:return $T;case 35668:case 35672:return YT;case 35669:case 35673:return jT;case 5125:return ZT;case 36294:return JT;case 36295:return KT;case 36296:return QT;case 35678:case 36198:case 36298:case 36306:case 35682:return eA;case 35679:case 36299:case 36307:return tA;case 35680:case 36300:case 36308:case 36293:return nA;case 36289:case 36303:case 36311:case 36292:return iA}}var Vp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=kT(t.type)}},Gp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=sA(t.type)}},Wp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},zp=/(\w+)(\])?(\[|\.)?/g;function gx(i,e){i.seq.push(e),i.map[e.id]=e}function rA(i,e,t){let n=i.name,s=n.length;for(zp.lastIndex=0;;){let r=zp.exec(n),o=zp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){gx(t,c===void 0?new Vp(a,i,e):new Gp(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Wp(a),gx(t,u)),t=u}}}var ha=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);rA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function bx(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var oA=37297,aA=0;function lA(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var xx=new Qe;function cA(i){yt._getMatrix(xx,yt.workingColorSpace,i);let e=`mat3( ${xx.elements.map(t=>t.toFixed(4))} )`;switch(yt.getTransfer(i)){case sl:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function vx(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+lA(i.getShaderSource(e),a)}else return r}function hA(i,e){let t=cA(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var uA={[fp]:"Linear",[dp]:"Reinhard",[pp]:"Cineon",[mp]:"ACESFilmic",[bp]:"AgX",[xp]:"Neutral",[gp]:"Custom"};function fA(i,e){let t=uA[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Pu=new I;function dA(){yt.getLuminanceCoefficients(Pu);let i=Pu.x.toFixed(4),e=Pu.y.toFixed(4),t=Pu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function pA(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Yl).join(`
`)}function mA(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function gA(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Yl(i){return i!==""}function yx(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function _x(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var bA=/^[ \t]*#include +<([\w\d./]+)>/gm;function Xp(i){return i.replace(bA,xA)}function xA(i,e){let t=dt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Xp(t)}var vA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function wx(i){return i.replace(vA,yA)}function yA(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Sx(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var _A={[Ol]:"SHADOWMAP_TYPE_PCF",[oa]:"SHADOWMAP_TYPE_VSM"};function wA(i){return _A[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var SA={[la]:"ENVMAP_MODE_REFRACTION"};function MA(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":SA[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var EA={[zh]:"ENVMAP_BLENDING_MULTIPLY",[Bb]:"ENVMAP_BLENDING_MIX",[zb]:"ENVMAP_BLENDING_ADD"};function TA(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":EA[i.combine]||"ENVMAP_BLENDING_NONE"}function AA(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=wA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=MA(t),u=TA(t),f=pA(t),d=mA(r),p=s.createProgram(),b,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Yl).join(`
`),b.length>0&&(b+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Yl).join(`
`),m.length>0&&(m+=`
`)):(b=[Sx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Yl).join(`
`),m=[Sx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Cs?"#define TONE_MAPPING":"",t.toneMapping!==Cs?dt.tonemapping_pars_fragment:"",t.toneMapping!==Cs?fA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",dt.colorspace_pars_fragment,hA("linearToOutputTexel",t.outputColorSpace),dA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Yl).join(`
`)),o=Xp(o),o=yx(o,t),o=_x(o,t),a=Xp(a),a=yx(a,t),a=_x(a,t),o=wx(o),a=wx(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,b=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,m=["#define varying in",t.glslVersion===Pp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Pp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=g+b+o,_=g+m+a,y=bx(s,s.VERTEX_SHADER,x),T=bx(s,s.FRAGMENT_SHADER,_);s.attachShader(p,y),s.attachShader(p,T),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(P){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(y)||"",z=s.getShaderInfoLog(T)||"",U=L.trim(),G=O.trim(),q=z.trim(),H=!0,ae=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,y,T);else{let Y=vx(s,y,"vertex"),ee=vx(s,T,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+U+`
`+Y+`
`+ee)}else U!==""?Ye("WebGLProgram: Program Info Log:",U):(G===""||q==="")&&(ae=!1);ae&&(P.diagnostics={runnable:H,programLog:U,vertexShader:{log:G,prefix:b},fragmentShader:{log:q,prefix:m}})}s.deleteShader(y),s.deleteShader(T),v=new ha(s,p),S=gA(s,p)}let v;this.getUniforms=function(){return v===void 0&&M(this),v};let S;this.getAttributes=function(){return S===void 0&&M(this),S};let C=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return C===!1&&(C=s.getProgramParameter(p,oA)),C},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=aA++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=y,this.fragmentShader=T,this}var RA=0,qp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new $p(e),t.set(e,n)),n}},$p=class{constructor(e){this.id=RA++,this.code=e,this.usedTimes=0}};function CA(i){return i===Nr||i===Gl||i===Wl}function PA(i,e,t,n,s,r){let o=new Ko,a=new qp,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,S,C,P,L,O){let z=P.fog,U=L.geometry,G=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,q=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,H=e.get(v.envMap||G,q),ae=f[v.type],Y=n.precision;v.precision!==null&&(Y=n.getMaxPrecision(v.precision),Y!==v.precision&&Ye("WebGLProgram.getParameters:",v.precision,"not supported, using",Y,"instead."));let ee=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,te=ee!==void 0?ee.length:0,de=0;U.morphAttributes.position!==void 0&&(de=1),U.morphAttributes.normal!==void 0&&(de=2),U.morphAttributes.color!==void 0&&(de=3);let ce,K,ue,ge;if(ae){let Ce=bi[ae];ce=Ce.vertexShader,K=Ce.fragmentShader}else{ce=v.vertexShader,K=v.fragmentShader;let Ce=a.getVertexShaderStage(v),ht=a.getFragmentShaderStage(v);a.update(v,Ce,ht),ue=Ce.id,ge=ht.id}let Me=i.getRenderTarget(),xe=i.state.buffers.depth.getReversed(),Ge=L.isInstancedMesh===!0,it=L.isBatchedMesh===!0,He=!!v.map,ct=!!v.matcap,at=!!H,Ze=at&&H.isPMREMTexture===!0,en=!!v.aoMap,Xt=!!v.lightMap,bn=!!v.bumpMap&&v.wireframe===!1,Ot=!!v.normalMap,Nn=!!v.displacementMap,wt=!!v.emissiveMap,Tn=!!v.metalnessMap,ln=!!v.roughnessMap,xn=v.anisotropy>0,B=v.clearcoat>0,Pe=v.diffuseRoughness>0,je=v.dispersion>0,lt=v.retroreflectivity>0,Ee=v.iridescence>0,zt=v.sheen>0,Ve=v.transmission>0,$e=xn&&!!v.anisotropyMap,D=B&&!!v.clearcoatMap,E=B&&!!v.clearcoatNormalMap,X=B&&!!v.clearcoatRoughnessMap,fe=Pe&&!!v.diffuseRoughnessMap,oe=Ee&&!!v.iridescenceMap,ve=Ee&&!!v.iridescenceThicknessMap,ye=zt&&!!v.sheenColorMap,ne=zt&&!!v.sheenRoughnessMap,se=!!v.specularMap,me=!!v.specularColorMap,k=!!v.specularIntensityMap,re=Ve&&!!v.transmissionMap,ie=Ve&&!!v.thicknessMap,Te=!!v.gradientMap,be=!!v.alphaMap,Se=v.alphaTest>0,We=!!v.alphaHash,et=!!v.extensions,he=Cs;v.toneMapped&&(Me===null||Me.isXRRenderTarget===!0)&&(he=i.toneMapping);let ke=Ze?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,tt={shaderID:ae,shaderType:v.type,shaderName:v.name,vertexShader:ce,fragmentShader:K,defines:v.defines,customVertexShaderID:ue,customFragmentShaderID:ge,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:Y,batching:it,batchingColor:it&&L._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&L.instanceColor!==null,instancingMorph:Ge&&L.morphTexture!==null,outputColorSpace:Me===null?i.outputColorSpace:Me.isXRRenderTarget===!0?Me.texture.colorSpace:yt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:He,matcap:ct,envMap:at,envMapMode:at&&H.mapping,envMapPMREM:Ze,envMapMaxLod:Ze?ke.length-1:null,envMapSize:Ze?ke[0].width:null,aoMap:en,lightMap:Xt,bumpMap:bn,normalMap:Ot,displacementMap:Nn,emissiveMap:wt,normalMapObjectSpace:Ot&&v.normalMapType===Gb,normalMapTangentSpace:Ot&&v.normalMapType===Au,packedNormalMap:Ot&&v.normalMapType===Au&&CA(v.normalMap.format),metalnessMap:Tn,roughnessMap:ln,anisotropy:xn,anisotropyMap:$e,clearcoat:B,clearcoatMap:D,clearcoatNormalMap:E,clearcoatRoughnessMap:X,diffuseRoughness:Pe,diffuseRoughnessMap:fe,dispersion:je,retroreflection:lt,iridescence:Ee,iridescenceMap:oe,iridescenceThicknessMap:ve,sheen:zt,sheenColorMap:ye,sheenRoughnessMap:ne,specularMap:se,specularColorMap:me,specularIntensityMap:k,transmission:Ve,transmissionMap:re,thicknessMap:ie,gradientMap:Te,opaque:v.transparent===!1&&v.blending===aa&&v.alphaToCoverage===!1,alphaMap:be,alphaTest:Se,alphaHash:We,combine:v.combine,mapUv:He&&d(v.map.channel),aoMapUv:en&&d(v.aoMap.channel),lightMapUv:Xt&&d(v.lightMap.channel),bumpMapUv:bn&&d(v.bumpMap.channel),normalMapUv:Ot&&d(v.normalMap.channel),displacementMapUv:Nn&&d(v.displacementMap.channel),emissiveMapUv:wt&&d(v.emissiveMap.channel),metalnessMapUv:Tn&&d(v.metalnessMap.channel),roughnessMapUv:ln&&d(v.roughnessMap.channel),anisotropyMapUv:$e&&d(v.anisotropyMap.channel),clearcoatMapUv:D&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:fe&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:ne&&d(v.sheenRoughnessMap.channel),specularMapUv:se&&d(v.specularMap.channel),specularColorMapUv:me&&d(v.specularColorMap.channel),specularIntensityMapUv:k&&d(v.specularIntensityMap.channel),transmissionMapUv:re&&d(v.transmissionMap.channel),thicknessMapUv:ie&&d(v.thicknessMap.channel),alphaMapUv:be&&d(v.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Ot||xn),vertexNormals:!!U.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!U.attributes.uv&&(He||be),fog:!!z,useFog:v.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||U.attributes.normal===void 0&&Ot===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:xe,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:de,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:O.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:He&&v.map.isVideoTexture===!0&&yt.getTransfer(v.map.colorSpace)===Pt,decodeVideoTextureEmissive:wt&&v.emissiveMap.isVideoTexture===!0&&yt.getTransfer(v.emissiveMap.colorSpace)===Pt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===an,flipSided:v.side===gi,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:et&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&v.extensions.multiDraw===!0||it)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function b(v){let S=[];if(v.shaderID?S.push(v.shaderID):(S.push(v.customVertexShaderID),S.push(v.customFragmentShaderID)),v.defines!==void 0)for(let C in v.defines)S.push(C),S.push(v.defines[C]);return v.isRawShaderMaterial===!1&&(m(S,v),g(S,v),S.push(i.outputColorSpace)),S.push(v.customProgramCacheKey),S.join()}function m(v,S){v.push(S.precision),v.push(S.outputColorSpace),v.push(S.envMapMode),v.push(S.envMapPMREM),v.push(S.envMapMaxLod),v.push(S.envMapSize),v.push(S.mapUv),v.push(S.alphaMapUv),v.push(S.lightMapUv),v.push(S.aoMapUv),v.push(S.bumpMapUv),v.push(S.normalMapUv),v.push(S.displacementMapUv),v.push(S.emissiveMapUv),v.push(S.metalnessMapUv),v.push(S.roughnessMapUv),v.push(S.anisotropyMapUv),v.push(S.clearcoatMapUv),v.push(S.clearcoatNormalMapUv),v.push(S.clearcoatRoughnessMapUv),v.push(S.diffuseRoughnessMapUv),v.push(S.iridescenceMapUv),v.push(S.iridescenceThicknessMapUv),v.push(S.sheenColorMapUv),v.push(S.sheenRoughnessMapUv),v.push(S.specularMapUv),v.push(S.specularColorMapUv),v.push(S.specularIntensityMapUv),v.push(S.transmissionMapUv),v.push(S.thicknessMapUv),v.push(S.combine),v.push(S.fogExp2),v.push(S.sizeAttenuation),v.push(S.morphTargetsCount),v.push(S.numSunLights),v.push(S.numDirLights),v.push(S.numPointLights),v.push(S.numSpotLights),v.push(S.numSpotLightMaps),v.push(S.numHemiLights),v.push(S.numRectAreaLights),v.push(S.numSunLightShadows),v.push(S.numDirLightShadows),v.push(S.numPointLightShadows),v.push(S.numSpotLightShadows),v.push(S.numSpotLightShadowsWithMaps),v.push(S.numLightProbes),v.push(S.numLightProbeGrids),v.push(S.shadowMapType),v.push(S.toneMapping),v.push(S.numClippingPlanes),v.push(S.numClipIntersection),v.push(S.depthPacking)}function g(v,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function x(v){let S=f[v.type],C;if(S){let P=bi[S];C=ql.clone(P.uniforms)}else C=v.uniforms;return C}function _(v,S){let C=h.get(S);return C!==void 0?++C.usedTimes:(C=new AA(i,S,v,s),c.push(C),h.set(S,C)),C}function y(v){if(--v.usedTimes===0){let S=c.indexOf(v);c[S]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function T(v){a.remove(v)}function M(){a.dispose()}return{getParameters:p,getProgramCacheKey:b,getUniforms:x,acquireProgram:_,releaseProgram:y,releaseShaderCache:T,programs:c,dispose:M}}function IA(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function LA(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Mx(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Ex(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,p,b,m,g){let x=i[e];return x===void 0?(x={id:f.id,object:f,geometry:d,material:p,materialVariant:o(f),groupOrder:b,renderOrder:f.renderOrder,z:m,group:g},i[e]=x):(x.id=f.id,x.object=f,x.geometry=d,x.material=p,x.materialVariant=o(f),x.groupOrder=b,x.renderOrder=f.renderOrder,x.z=m,x.group=g),e++,x}function l(f,d,p,b,m,g,x){x.reversedDepth===!0&&(m=-m);let _=a(f,d,p,b,m,g);p.transmission>0?n.push(_):p.transparent===!0?s.push(_):t.push(_)}function c(f,d,p,b,m,g){let x=a(f,d,p,b,m,g);p.transmission>0?n.unshift(x):p.transparent===!0?s.unshift(x):t.unshift(x)}function h(f,d){t.length>1&&t.sort(f||LA),n.length>1&&n.sort(d||Mx),s.length>1&&s.sort(d||Mx)}function u(){for(let f=e,d=i.length;f<d;f++){let p=i[f];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function DA(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Ex,i.set(n,[o])):s>=r.length?(o=new Ex,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function NA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new I,color:new Xe};break;case"SpotLight":t={position:new I,direction:new I,color:new Xe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new I,color:new Xe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new I,skyColor:new Xe,groundColor:new Xe};break;case"RectAreaLight":t={color:new Xe,position:new I,halfWidth:new I,halfHeight:new I};break}return i[e.id]=t,t}}}function UA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var FA=0;function OA(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function kA(i){let e=new NA,t=UA(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new I);let s=new I,r=new xt,o=new xt;function a(c){let h=0,u=0,f=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let d=0,p=0,b=0,m=0,g=0,x=0,_=0,y=0,T=0,M=0,v=0,S=0,C=0,P=0;c.sort(OA);for(let O=0,z=c.length;O<z;O++){let U=c[O],G=U.color,q=U.intensity,H=U.distance,ae=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===Nr?ae=U.shadow.map.texture:ae=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=G.r*q,u+=G.g*q,f+=G.b*q;else if(U.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(U.sh.coefficients[Y],q);P++}else if(U.isSunLight){let Y=e.get(U);if(Y.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let ee=U.shadow,te=t.get(U);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),n.sunShadow[p]=te,n.sunShadowMap[p]=ae;let de=ee.getViewportCount();for(let ce=0;ce<de;ce++)n.sunShadowMatrix[b+ce]=ee.getMatrix(ce),n.sunShadowCascade[b+ce]=ee._cascadeData[ce];b+=de,p++}n.sun[d]=Y,d++}else if(U.isDirectionalLight){let Y=e.get(U);if(Y.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let ee=U.shadow,te=t.get(U);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize=ee.mapSize,n.directionalShadow[m]=te,n.directionalShadowMap[m]=ae,n.directionalShadowMatrix[m]=U.shadow.matrix,T++}n.directional[m]=Y,m++}else if(U.isSpotLight){let Y=e.get(U);Y.position.setFromMatrixPosition(U.matrixWorld),Y.color.copy(G).multiplyScalar(q),Y.distance=H,Y.coneCos=Math.cos(U.angle),Y.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),Y.decay=U.decay,n.spot[x]=Y;let ee=U.shadow;if(U.map&&(n.spotLightMap[S]=U.map,S++,ee.updateMatrices(U),U.castShadow&&C++),n.spotLightMatrix[x]=ee.matrix,U.castShadow){let te=t.get(U);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize=ee.mapSize,n.spotShadow[x]=te,n.spotShadowMap[x]=ae,v++}x++}else if(U.isRectAreaLight){let Y=e.get(U);Y.color.copy(G).multiplyScalar(q),Y.halfWidth.set(U.width*.5,0,0),Y.halfHeight.set(0,U.height*.5,0),n.rectArea[_]=Y,_++}else if(U.isPointLight){let Y=e.get(U);if(Y.color.copy(U.color).multiplyScalar(U.intensity),Y.distance=U.distance,Y.decay=U.decay,U.castShadow){let ee=U.shadow,te=t.get(U);te.shadowIntensity=ee.intensity,te.shadowBias=ee.bias,te.shadowNormalBias=ee.normalBias,te.shadowRadius=ee.radius,te.shadowMapSize=ee.mapSize,te.shadowCameraNear=ee.camera.near,te.shadowCameraFar=ee.camera.far,n.pointShadow[g]=te,n.pointShadowMap[g]=ae,n.pointShadowMatrix[g]=U.shadow.matrix,M++}n.point[g]=Y,g++}else if(U.isHemisphereLight){let Y=e.get(U);Y.skyColor.copy(U.color).multiplyScalar(q),Y.groundColor.copy(U.groundColor).multiplyScalar(q),n.hemi[y]=Y,y++}}_>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ie.LTC_FLOAT_1,n.rectAreaLTC2=Ie.LTC_FLOAT_2):(n.rectAreaLTC1=Ie.LTC_HALF_1,n.rectAreaLTC2=Ie.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let L=n.hash;(L.sunLength!==d||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==x||L.rectAreaLength!==_||L.hemiLength!==y||L.numSunShadows!==p||L.numDirectionalShadows!==T||L.numPointShadows!==M||L.numSpotShadows!==v||L.numSpotMaps!==S||L.numLightProbes!==P)&&(n.sun.length=d,n.directional.length=m,n.spot.length=x,n.rectArea.length=_,n.point.length=g,n.hemi.length=y,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=b,n.sunShadowCascade.length=b,n.directionalShadow.length=T,n.directionalShadowMap.length=T,n.directionalShadowMatrix.length=T,n.pointShadow.length=M,n.pointShadowMap.length=M,n.pointShadowMatrix.length=M,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+S-C,n.spotLightMap.length=S,n.numSpotLightShadowsWithMaps=C,n.numLightProbes=P,L.sunLength=d,L.directionalLength=m,L.pointLength=g,L.spotLength=x,L.rectAreaLength=_,L.hemiLength=y,L.numSunShadows=p,L.numDirectionalShadows=T,L.numPointShadows=M,L.numSpotShadows=v,L.numSpotMaps=S,L.numLightProbes=P,n.version=FA++)}function l(c,h){let u=0,f=0,d=0,p=0,b=0,m=0,g=h.matrixWorldInverse;for(let x=0,_=c.length;x<_;x++){let y=c[x];if(y.isSunLight){let T=n.sun[u];T.direction.setFromMatrixPosition(y.matrixWorld),T.direction.transformDirection(g),u++}else if(y.isDirectionalLight){let T=n.directional[f];T.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(g),f++}else if(y.isSpotLight){let T=n.spot[p];T.position.setFromMatrixPosition(y.matrixWorld),T.position.applyMatrix4(g),T.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(g),p++}else if(y.isRectAreaLight){let T=n.rectArea[b];T.position.setFromMatrixPosition(y.matrixWorld),T.position.applyMatrix4(g),o.identity(),r.copy(y.matrixWorld),r.premultiply(g),o.extractRotation(r),T.halfWidth.set(y.width*.5,0,0),T.halfHeight.set(0,y.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),b++}else if(y.isPointLight){let T=n.point[d];T.position.setFromMatrixPosition(y.matrixWorld),T.position.applyMatrix4(g),d++}else if(y.isHemisphereLight){let T=n.hemi[m];T.direction.setFromMatrixPosition(y.matrixWorld),T.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function Tx(i){let e=new kA(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function BA(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Tx(i),e.set(s,[a])):r>=o.length?(a=new Tx(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var zA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,HA=`uniform sampler2D shadow_pass;
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
}`,VA=[new I(1,0,0),new I(-1,0,0),new I(0,1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1)],GA=[new I(0,-1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1),new I(0,-1,0),new I(0,-1,0)],Ax=new xt,$l=new I,Hp=new I;function WA(i,e,t){let n=new Rr,s=new we,r=new we,o=new It,a=new Th,l=new Ah,c={},h=t.maxTextureSize,u={[Rs]:gi,[gi]:Rs,[an]:an},f=new _i({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new we},radius:{value:4}},vertexShader:zA,fragmentShader:HA}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let p=new gt;p.setAttribute("position",new dn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Lt(p,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ol;let g=this.type;this.render=function(M,v,S){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||M.length===0)return;this.type===yb&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ol);let C=i.getRenderTarget(),P=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),O=i.state;O.setBlending(ir),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=g!==this.type;z&&v.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(G=>G.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,G=M.length;U<G;U++){let q=M[U],H=q.shadow;if(H===void 0){Ye("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ae=H.getFrameExtents();s.multiply(ae),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ae.x),s.x=r.x*ae.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ae.y),s.y=r.y*ae.y,H.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Y,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===oa){if(q.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new $n(s.x,s.y,{format:Nr,type:ls,minFilter:pi,magFilter:pi,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new os(s.x,s.y,Yi),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=js,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=qt,H.map.depthTexture.magFilter=qt}else q.isPointLight?(H.map=new jl(s.x),H.map.depthTexture=new dl(s.x,Fi)):(H.map=new $n(s.x,s.y),H.map.depthTexture=new os(s.x,s.y,Fi)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=js,this.type===Ol?(H.map.depthTexture.compareFunction=Y?Ap:Tp,H.map.depthTexture.minFilter=pi,H.map.depthTexture.magFilter=pi):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=qt,H.map.depthTexture.magFilter=qt);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let ee=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,S);let te=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:S.layers;for(let de=0;de<ee;de++){let ce=H.getCamera(de);if(q.isPointLight){let K=H.camera,ue=H.matrix,ge=q.distance||K.far;ge!==K.far&&(K.far=ge,K.updateProjectionMatrix()),$l.setFromMatrixPosition(q.matrixWorld),K.position.copy($l),Hp.copy(K.position),Hp.add(VA[de]),K.up.copy(GA[de]),K.lookAt(Hp),K.updateMatrixWorld(),ue.makeTranslation(-$l.x,-$l.y,-$l.z),Ax.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Ax,K.coordinateSystem,K.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,de),i.clear();else{de===0&&(i.setRenderTarget(H.map),i.clear());let K=H.getViewport(de);o.set(r.x*K.x,r.y*K.y,r.x*K.z,r.y*K.w),O.viewport(o)}n=H.getFrustum(de),y(v,S,ce,q,te,this.type)}H.isPointLightShadow!==!0&&this.type===oa&&x(H,S),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(C,P,L)};function x(M,v){let S=e.update(b);f.defines.VSM_SAMPLES!==M.blurSamples&&(f.defines.VSM_SAMPLES=M.blurSamples,d.defines.VSM_SAMPLES=M.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),M.mapPass===null?M.mapPass=new $n(s.x,s.y,{format:Nr,type:ls}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),f.uniforms.shadow_pass.value=M.map.depthTexture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,i.setRenderTarget(M.mapPass),i.clear(),i.renderBufferDirect(v,null,S,f,b,null),d.uniforms.shadow_pass.value=M.mapPass.texture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,i.setRenderTarget(M.map),i.clear(),i.renderBufferDirect(v,null,S,d,b,null)}function _(M,v,S,C){let P=null,L=S.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(L!==void 0)P=L;else if(P=S.isPointLight===!0?l:a,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let O=P.uuid,z=v.uuid,U=c[O];U===void 0&&(U={},c[O]=U);let G=U[z];G===void 0&&(G=P.clone(),U[z]=G,v.addEventListener("dispose",T)),P=G}if(P.visible=v.visible,P.wireframe=v.wireframe,C===oa?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:u[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,S.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let O=i.properties.get(P);O.light=S}return P}function y(M,v,S,C,P,L){if(M.visible===!1)return;if(M.layers.test(P)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&L===oa)&&(!M.frustumCulled||M.intersectsFrustum(n))){M.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,M.matrixWorld);let U=e.update(M),G=M.material;if(Array.isArray(G)){let q=U.groups;for(let H=0,ae=q.length;H<ae;H++){let Y=q[H],ee=G[Y.materialIndex];if(ee&&ee.visible){let te=_(M,ee,C,L);M.onBeforeShadow(i,M,v,S,U,te,Y),i.renderBufferDirect(S,null,U,te,M,Y),M.onAfterShadow(i,M,v,S,U,te,Y)}}}else if(G.visible){let q=_(M,G,C,L);M.onBeforeShadow(i,M,v,S,U,q,null),i.renderBufferDirect(S,null,U,q,M,null),M.onAfterShadow(i,M,v,S,U,q,null)}}let z=M.children;for(let U=0,G=z.length;U<G;U++)y(z[U],v,S,C,P,L)}function T(M){M.target.removeEventListener("dispose",T);for(let S in c){let C=c[S],P=M.target.uuid;P in C&&(C[P].dispose(),delete C[P])}}}function XA(i,e){function t(){let k=!1,re=new It,ie=null,Te=new It(0,0,0,0);return{setMask:function(be){ie!==be&&!k&&(i.colorMask(be,be,be,be),ie=be)},setLocked:function(be){k=be},setClear:function(be,Se,We,et,he){he===!0&&(be*=et,Se*=et,We*=et),re.set(be,Se,We,et),Te.equals(re)===!1&&(i.clearColor(be,Se,We,et),Te.copy(re))},reset:function(){k=!1,ie=null,Te.set(-1,0,0,0)}}}function n(){let k=!1,re=!1,ie=null,Te=null,be=null;return{setReversed:function(Se){if(re!==Se){let We=e.get("EXT_clip_control");Se?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let et=be;be=null,this.setClear(et)}},getReversed:function(){return re},setTest:function(Se){Se?xe(i.DEPTH_TEST):Ge(i.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!k&&(i.depthMask(Se),ie=Se)},setFunc:function(Se){if(re&&(Se=Qb[Se]),Te!==Se){switch(Se){case nh:i.depthFunc(i.NEVER);break;case ih:i.depthFunc(i.ALWAYS);break;case sh:i.depthFunc(i.LESS);break;case $o:i.depthFunc(i.LEQUAL);break;case rh:i.depthFunc(i.EQUAL);break;case oh:i.depthFunc(i.GEQUAL);break;case ah:i.depthFunc(i.GREATER);break;case lh:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Se}},setLocked:function(Se){k=Se},setClear:function(Se){be!==Se&&(be=Se,re&&(Se=1-Se),i.clearDepth(Se))},reset:function(){k=!1,ie=null,Te=null,be=null,re=!1}}}function s(){let k=!1,re=null,ie=null,Te=null,be=null,Se=null,We=null,et=null,he=null;return{setTest:function(ke){k||(ke?xe(i.STENCIL_TEST):Ge(i.STENCIL_TEST))},setMask:function(ke){re!==ke&&!k&&(i.stencilMask(ke),re=ke)},setFunc:function(ke,tt,Ce){(ie!==ke||Te!==tt||be!==Ce)&&(i.stencilFunc(ke,tt,Ce),ie=ke,Te=tt,be=Ce)},setOp:function(ke,tt,Ce){(Se!==ke||We!==tt||et!==Ce)&&(i.stencilOp(ke,tt,Ce),Se=ke,We=tt,et=Ce)},setLocked:function(ke){k=ke},setClear:function(ke){he!==ke&&(i.clearStencil(ke),he=ke)},reset:function(){k=!1,re=null,ie=null,Te=null,be=null,Se=null,We=null,et=null,he=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,p=[],b=null,m=!1,g=null,x=null,_=null,y=null,T=null,M=null,v=null,S=new Xe(0,0,0),C=0,P=!1,L=null,O=null,z=null,U=null,G=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ae=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec(Y)[1]),H=ae>=1):Y.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),H=ae>=2);let ee=null,te={},de=i.getParameter(i.SCISSOR_BOX),ce=i.getParameter(i.VIEWPORT),K=new It().fromArray(de),ue=new It().fromArray(ce);function ge(k,re,ie,Te){let be=new Uint8Array(4),Se=i.createTexture();i.bindTexture(k,Se),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let We=0;We<ie;We++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,be):i.texImage2D(re+We,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,be);return Se}let Me={};Me[i.TEXTURE_2D]=ge(i.TEXTURE_2D,i.TEXTURE_2D,1),Me[i.TEXTURE_CUBE_MAP]=ge(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Me[i.TEXTURE_2D_ARRAY]=ge(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Me[i.TEXTURE_3D]=ge(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xe(i.DEPTH_TEST),o.setFunc($o),bn(!1),Ot(op),xe(i.CULL_FACE),en(ir);function xe(k){h[k]!==!0&&(i.enable(k),h[k]=!0)}function Ge(k){h[k]!==!1&&(i.disable(k),h[k]=!1)}function it(k,re){return f[k]!==re?(i.bindFramebuffer(k,re),f[k]=re,k===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=re),k===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=re),!0):!1}function He(k,re){let ie=p,Te=!1;if(k){ie=d.get(re),ie===void 0&&(ie=[],d.set(re,ie));let be=k.textures;if(ie.length!==be.length||ie[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,We=be.length;Se<We;Se++)ie[Se]=i.COLOR_ATTACHMENT0+Se;ie.length=be.length,Te=!0}}else ie[0]!==i.BACK&&(ie[0]=i.BACK,Te=!0);Te&&i.drawBuffers(ie)}function ct(k){return b!==k?(i.useProgram(k),b=k,!0):!1}let at={[eo]:i.FUNC_ADD,[wb]:i.FUNC_SUBTRACT,[Sb]:i.FUNC_REVERSE_SUBTRACT};at[Mb]=i.MIN,at[Eb]=i.MAX;let Ze={[Tb]:i.ZERO,[Ab]:i.ONE,[Rb]:i.SRC_COLOR,[hp]:i.SRC_ALPHA,[Nb]:i.SRC_ALPHA_SATURATE,[Lb]:i.DST_COLOR,[Pb]:i.DST_ALPHA,[Cb]:i.ONE_MINUS_SRC_COLOR,[up]:i.ONE_MINUS_SRC_ALPHA,[Db]:i.ONE_MINUS_DST_COLOR,[Ib]:i.ONE_MINUS_DST_ALPHA,[Ub]:i.CONSTANT_COLOR,[Fb]:i.ONE_MINUS_CONSTANT_COLOR,[Ob]:i.CONSTANT_ALPHA,[kb]:i.ONE_MINUS_CONSTANT_ALPHA};function en(k,re,ie,Te,be,Se,We,et,he,ke){if(k===ir){m===!0&&(Ge(i.BLEND),m=!1);return}if(m===!1&&(xe(i.BLEND),m=!0),k!==_b){if(k!==g||ke!==P){if((x!==eo||T!==eo)&&(i.blendEquation(i.FUNC_ADD),x=eo,T=eo),ke)switch(k){case aa:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ap:i.blendFunc(i.ONE,i.ONE);break;case lp:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case cp:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:nt("WebGLState: Invalid blending: ",k);break}else switch(k){case aa:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ap:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case lp:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case cp:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",k);break}_=null,y=null,M=null,v=null,S.set(0,0,0),C=0,g=k,P=ke}return}be=be||re,Se=Se||ie,We=We||Te,(re!==x||be!==T)&&(i.blendEquationSeparate(at[re],at[be]),x=re,T=be),(ie!==_||Te!==y||Se!==M||We!==v)&&(i.blendFuncSeparate(Ze[ie],Ze[Te],Ze[Se],Ze[We]),_=ie,y=Te,M=Se,v=We),(et.equals(S)===!1||he!==C)&&(i.blendColor(et.r,et.g,et.b,he),S.copy(et),C=he),g=k,P=!1}function Xt(k,re){k.side===an?Ge(i.CULL_FACE):xe(i.CULL_FACE);let ie=k.side===gi;re&&(ie=!ie),bn(ie),k.blending===aa&&k.transparent===!1?en(ir):en(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Te=k.stencilWrite;a.setTest(Te),Te&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),wt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?xe(i.SAMPLE_ALPHA_TO_COVERAGE):Ge(i.SAMPLE_ALPHA_TO_COVERAGE)}function bn(k){L!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),L=k)}function Ot(k){k!==xb?(xe(i.CULL_FACE),k!==O&&(k===op?i.cullFace(i.BACK):k===vb?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ge(i.CULL_FACE),O=k}function Nn(k){k!==z&&(H&&i.lineWidth(k),z=k)}function wt(k,re,ie){k?(xe(i.POLYGON_OFFSET_FILL),(U!==re||G!==ie)&&(U=re,G=ie,o.getReversed()&&(re=-re,ie=-ie),i.polygonOffset(re,ie))):Ge(i.POLYGON_OFFSET_FILL)}function Tn(k){k?xe(i.SCISSOR_TEST):Ge(i.SCISSOR_TEST)}function ln(k){k===void 0&&(k=i.TEXTURE0+q-1),ee!==k&&(i.activeTexture(k),ee=k)}function xn(k,re,ie){ie===void 0&&(ee===null?ie=i.TEXTURE0+q-1:ie=ee);let Te=te[ie];Te===void 0&&(Te={type:void 0,texture:void 0},te[ie]=Te),(Te.type!==k||Te.texture!==re)&&(ee!==ie&&(i.activeTexture(ie),ee=ie),i.bindTexture(k,re||Me[k]),Te.type=k,Te.texture=re)}function B(){let k=te[ee];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Pe(){try{i.compressedTexImage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function je(){try{i.compressedTexImage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function lt(){try{i.texSubImage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function Ee(){try{i.texSubImage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function zt(){try{i.compressedTexSubImage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function $e(){try{i.texStorage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function D(){try{i.texStorage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function E(){try{i.texImage2D(...arguments)}catch(k){nt("WebGLState:",k)}}function X(){try{i.texImage3D(...arguments)}catch(k){nt("WebGLState:",k)}}function fe(k){return u[k]!==void 0?u[k]:i.getParameter(k)}function oe(k,re){u[k]!==re&&(i.pixelStorei(k,re),u[k]=re)}function ve(k){K.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),K.copy(k))}function ye(k){ue.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),ue.copy(k))}function ne(k,re){let ie=c.get(re);ie===void 0&&(ie=new WeakMap,c.set(re,ie));let Te=ie.get(k);Te===void 0&&(Te=i.getUniformBlockIndex(re,k.name),i.uniformBlockBinding(re,Te,Te),ie.set(k,Te))}function se(k,re,ie){let be=c.get(re).get(k);l[be]!==ie&&(i.bindBufferBase(i.UNIFORM_BUFFER,be,ie),l[be]=ie)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},ee=null,te={},f={},l={},d=new WeakMap,p=[],b=null,m=!1,g=null,x=null,_=null,y=null,T=null,M=null,v=null,S=new Xe(0,0,0),C=0,P=!1,L=null,O=null,z=null,U=null,G=null,K.set(0,0,i.canvas.width,i.canvas.height),ue.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xe,disable:Ge,bindFramebuffer:it,drawBuffers:He,useProgram:ct,setBlending:en,setMaterial:Xt,setFlipSided:bn,setCullFace:Ot,setLineWidth:Nn,setPolygonOffset:wt,setScissorTest:Tn,activeTexture:ln,bindTexture:xn,unbindTexture:B,compressedTexImage2D:Pe,compressedTexImage3D:je,texImage2D:E,texImage3D:X,pixelStorei:oe,getParameter:fe,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:$e,texStorage3D:D,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:zt,compressedTexSubImage3D:Ve,scissor:ve,viewport:ye,reset:me}}function qA(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new we,h=new WeakMap,u=new Set,f,d=new WeakMap,p=new Set,b=new FinalizationRegistry(D=>p.delete(D)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(D,E){return m?new OffscreenCanvas(D,E):rl("canvas")}function x(D,E,X){let fe=1,oe=$e(D);if((oe.width>X||oe.height>X)&&(fe=X/Math.max(oe.width,oe.height)),fe<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){let ve=Math.floor(fe*oe.width),ye=Math.floor(fe*oe.height);f===void 0&&(f=g(ve,ye));let ne=E?g(ve,ye):f;return ne.width=ve,ne.height=ye,ne.getContext("2d").drawImage(D,0,0,ve,ye),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ve+"x"+ye+")."),ne}else return"data"in D&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),D;return D}function _(D){return D.generateMipmaps}function y(D){i.generateMipmap(D)}function T(D){return D.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?i.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(D,E,X,fe,oe,ve=!1){if(D!==null){if(i[D]!==void 0)return i[D];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let ye;fe&&(ye=e.get("EXT_texture_norm16"),ye||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=E;if(E===i.RED&&(X===i.FLOAT&&(ne=i.R32F),X===i.HALF_FLOAT&&(ne=i.R16F),X===i.UNSIGNED_BYTE&&(ne=i.R8),X===i.UNSIGNED_SHORT&&ye&&(ne=ye.R16_EXT),X===i.SHORT&&ye&&(ne=ye.R16_SNORM_EXT)),E===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(ne=i.R8UI),X===i.UNSIGNED_SHORT&&(ne=i.R16UI),X===i.UNSIGNED_INT&&(ne=i.R32UI),X===i.BYTE&&(ne=i.R8I),X===i.SHORT&&(ne=i.R16I),X===i.INT&&(ne=i.R32I)),E===i.RG&&(X===i.FLOAT&&(ne=i.RG32F),X===i.HALF_FLOAT&&(ne=i.RG16F),X===i.UNSIGNED_BYTE&&(ne=i.RG8),X===i.UNSIGNED_SHORT&&ye&&(ne=ye.RG16_EXT),X===i.SHORT&&ye&&(ne=ye.RG16_SNORM_EXT)),E===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(ne=i.RG8UI),X===i.UNSIGNED_SHORT&&(ne=i.RG16UI),X===i.UNSIGNED_INT&&(ne=i.RG32UI),X===i.BYTE&&(ne=i.RG8I),X===i.SHORT&&(ne=i.RG16I),X===i.INT&&(ne=i.RG32I)),E===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(ne=i.RGB8UI),X===i.UNSIGNED_SHORT&&(ne=i.RGB16UI),X===i.UNSIGNED_INT&&(ne=i.RGB32UI),X===i.BYTE&&(ne=i.RGB8I),X===i.SHORT&&(ne=i.RGB16I),X===i.INT&&(ne=i.RGB32I)),E===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(ne=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(ne=i.RGBA16UI),X===i.UNSIGNED_INT&&(ne=i.RGBA32UI),X===i.BYTE&&(ne=i.RGBA8I),X===i.SHORT&&(ne=i.RGBA16I),X===i.INT&&(ne=i.RGBA32I)),E===i.RGB&&(X===i.UNSIGNED_SHORT&&ye&&(ne=ye.RGB16_EXT),X===i.SHORT&&ye&&(ne=ye.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(ne=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(ne=i.R11F_G11F_B10F)),E===i.RGBA){let se=ve?sl:yt.getTransfer(oe);X===i.FLOAT&&(ne=i.RGBA32F),X===i.HALF_FLOAT&&(ne=i.RGBA16F),X===i.UNSIGNED_BYTE&&(ne=se===Pt?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&ye&&(ne=ye.RGBA16_EXT),X===i.SHORT&&ye&&(ne=ye.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(ne=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(ne=i.RGB5_A1)}return(ne===i.R16F||ne===i.R32F||ne===i.RG16F||ne===i.RG32F||ne===i.RGBA16F||ne===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function v(D,E){let X;return D?E===null||E===Fi||E===no?X=i.DEPTH24_STENCIL8:E===Yi?X=i.DEPTH32F_STENCIL8:E===ca&&(X=i.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===Fi||E===no?X=i.DEPTH_COMPONENT24:E===Yi?X=i.DEPTH_COMPONENT32F:E===ca&&(X=i.DEPTH_COMPONENT16),X}function S(D,E){return _(D)===!0||D.isFramebufferTexture&&D.minFilter!==qt&&D.minFilter!==pi?Math.log2(Math.max(E.width,E.height))+1:D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?E.mipmaps.length:1}function C(D){let E=new WeakRef(D);n.get(D).__ref=E,p.add(E),b.register(D,E,E)}function P(D){let E=n.get(D).__ref;E!==void 0&&(p.delete(E),b.unregister(E))}function L(D){z(D.target)}function O(D){U(D.target)}function z(D){D.removeEventListener("dispose",L),P(D),q(D),D.isVideoTexture&&h.delete(D),D.isHTMLTexture&&u.delete(D)}function U(D){D.removeEventListener("dispose",O),P(D),ae(D)}function G(){for(let D of p){let E=D.deref();E!==void 0&&(E.isRenderTarget===!0?U(E):z(E))}p.clear(),u.clear()}function q(D){let E=n.get(D);if(E.__webglInit===void 0)return;let X=D.source,fe=d.get(X);if(fe){let oe=fe[E.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(D),Object.keys(fe).length===0&&d.delete(X)}n.remove(D)}function H(D){let E=n.get(D);i.deleteTexture(E.__webglTexture);let X=D.source,fe=d.get(X);delete fe[E.__cacheKey],o.memory.textures--}function ae(D){let E=n.get(D);E.__depthDisposeCallback&&E.__depthDisposeCallback();let X=D.depthTexture;if(X&&X.renderTarget===D&&z(X),D.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(E.__webglFramebuffer[oe]))for(let ve=0;ve<E.__webglFramebuffer[oe].length;ve++)i.deleteFramebuffer(E.__webglFramebuffer[oe][ve]);else i.deleteFramebuffer(E.__webglFramebuffer[oe]);E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer[oe])}else{if(Array.isArray(E.__webglFramebuffer))for(let oe=0;oe<E.__webglFramebuffer.length;oe++)i.deleteFramebuffer(E.__webglFramebuffer[oe]);else i.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&i.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let oe=0;oe<E.__webglColorRenderbuffer.length;oe++)E.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(E.__webglColorRenderbuffer[oe]);E.__webglDepthRenderbuffer&&i.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let fe=D.textures;for(let oe=0,ve=fe.length;oe<ve;oe++){let ye=n.get(fe[oe]);ye.__webglTexture&&(i.deleteTexture(ye.__webglTexture),o.memory.textures--),n.remove(fe[oe])}n.remove(D)}let Y=0;function ee(){Y=0}function te(){return Y}function de(D){Y=D}function ce(){let D=Y;return D>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(D+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,D}function K(D){let E=[];return E.push(D.wrapS),E.push(D.wrapT),E.push(D.wrapR||0),E.push(D.magFilter),E.push(D.minFilter),E.push(D.anisotropy),E.push(D.internalFormat),E.push(D.format),E.push(D.type),E.push(D.generateMipmaps),E.push(D.mipmapsAutoUpdate),E.push(D.premultiplyAlpha),E.push(D.flipY),E.push(D.unpackAlignment),E.push(D.colorSpace),E.join()}function ue(D,E){let X=n.get(D);if(D.isVideoTexture&&zt(D),D.isRenderTargetTexture===!1&&D.isExternalTexture!==!0&&D.version>0&&X.__version!==D.version){let fe=D.image;if(fe===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(fe.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Xt(X,D,E);return}}else D.isExternalTexture&&(X.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+E)}function ge(D,E){let X=n.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&X.__version!==D.version){Xt(X,D,E);return}else D.isExternalTexture&&(X.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+E)}function Me(D,E){let X=n.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&X.__version!==D.version){Xt(X,D,E);return}t.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+E)}function xe(D,E){let X=n.get(D);if(D.version>0&&X.__version!==D.version){bn(X,D,E);return}t.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+E)}let Ge={[ch]:i.REPEAT,[Ss]:i.CLAMP_TO_EDGE,[hh]:i.MIRRORED_REPEAT},it={[qt]:i.NEAREST,[Hb]:i.NEAREST_MIPMAP_NEAREST,[kl]:i.NEAREST_MIPMAP_LINEAR,[pi]:i.LINEAR,[Gh]:i.LINEAR_MIPMAP_NEAREST,[sr]:i.LINEAR_MIPMAP_LINEAR},He={[Xb]:i.NEVER,[Rp]:i.ALWAYS,[qb]:i.LESS,[Tp]:i.LEQUAL,[$b]:i.EQUAL,[Ap]:i.GEQUAL,[Yb]:i.GREATER,[jb]:i.NOTEQUAL};function ct(D,E){if(E.type===Yi&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===pi||E.magFilter===Gh||E.magFilter===kl||E.magFilter===sr||E.minFilter===pi||E.minFilter===Gh||E.minFilter===kl||E.minFilter===sr)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(D,i.TEXTURE_WRAP_S,Ge[E.wrapS]),i.texParameteri(D,i.TEXTURE_WRAP_T,Ge[E.wrapT]),(D===i.TEXTURE_3D||D===i.TEXTURE_2D_ARRAY)&&i.texParameteri(D,i.TEXTURE_WRAP_R,Ge[E.wrapR]),i.texParameteri(D,i.TEXTURE_MAG_FILTER,it[E.magFilter]),i.texParameteri(D,i.TEXTURE_MIN_FILTER,it[E.minFilter]),E.compareFunction&&(i.texParameteri(D,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(D,i.TEXTURE_COMPARE_FUNC,He[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===qt||E.minFilter!==kl&&E.minFilter!==sr||E.type===Yi&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||n.get(E).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");i.texParameterf(D,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),n.get(E).__currentAnisotropy=E.anisotropy}}}function at(D,E){let X=!1;D.__webglInit===void 0&&(D.__webglInit=!0,E.addEventListener("dispose",L),C(E));let fe=E.source,oe=d.get(fe);oe===void 0&&(oe={},d.set(fe,oe));let ve=K(E);if(ve!==D.__cacheKey){oe[ve]===void 0&&(oe[ve]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[ve].usedTimes++;let ye=oe[D.__cacheKey];ye!==void 0&&(oe[D.__cacheKey].usedTimes--,ye.usedTimes===0&&H(E)),D.__cacheKey=ve,D.__webglTexture=oe[ve].texture}return X}function Ze(D,E,X){return Math.floor(Math.floor(D/X)/E)}function en(D,E,X,fe){let ve=D.updateRanges;if(ve.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,E.width,E.height,X,fe,E.data);else{ve.sort((k,re)=>k.start-re.start);let ye=0;for(let k=1;k<ve.length;k++){let re=ve[ye],ie=ve[k],Te=re.start+re.count,be=Ze(ie.start,E.width,4),Se=Ze(re.start,E.width,4);ie.start<=Te+1&&be===Se&&Ze(ie.start+ie.count-1,E.width,4)===be?re.count=Math.max(re.count,ie.start+ie.count-re.start):(++ye,ve[ye]=ie)}ve.length=ye+1;let ne=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,E.width);for(let k=0,re=ve.length;k<re;k++){let ie=ve[k],Te=Math.floor(ie.start/4),be=Math.ceil(ie.count/4),Se=Te%E.width,We=Math.floor(Te/E.width),et=be,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,We),t.texSubImage2D(i.TEXTURE_2D,0,Se,We,et,he,X,fe,E.data)}D.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ne),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Xt(D,E,X){let fe=i.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(fe=i.TEXTURE_2D_ARRAY),E.isData3DTexture&&(fe=i.TEXTURE_3D);let oe=at(D,E),ve=E.source;t.bindTexture(fe,D.__webglTexture,i.TEXTURE0+X);let ye=n.get(ve);if(ve.version!==ye.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let he=yt.getPrimaries(yt.workingColorSpace),ke=E.colorSpace===or?null:yt.getPrimaries(E.colorSpace),tt=E.colorSpace===or||he===ke?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment);let se=x(E.image,!1,s.maxTextureSize);se=Ve(E,se);let me=r.convert(E.format,E.colorSpace),k=r.convert(E.type),re=M(E.internalFormat,me,k,E.normalized,E.colorSpace,E.isVideoTexture);ct(fe,E);let ie,Te=E.mipmaps,be=E.isVideoTexture!==!0,Se=ye.__version===void 0||oe===!0,We=ve.dataReady,et=S(E,se);if(E.isDepthTexture)re=v(E.format===rr,E.type),Se&&(be?t.texStorage2D(i.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,me,k,null));else if(E.isDataTexture)if(Te.length>0){be&&Se&&t.texStorage2D(i.TEXTURE_2D,et,re,Te[0].width,Te[0].height);for(let he=0,ke=Te.length;he<ke;he++)ie=Te[he],be?We&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,k,ie.data):t.texImage2D(i.TEXTURE_2D,he,re,ie.width,ie.height,0,me,k,ie.data);E.generateMipmaps=!1}else be?(Se&&t.texStorage2D(i.TEXTURE_2D,et,re,se.width,se.height),We&&en(E,se,me,k)):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,me,k,se.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){be&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,re,Te[0].width,Te[0].height,se.depth);for(let he=0,ke=Te.length;he<ke;he++)if(ie=Te[he],E.format!==cs)if(me!==null)if(be){if(We)if(E.layerUpdates.size>0){let tt=Bp(ie.width,ie.height,E.format,E.type);for(let Ce of E.layerUpdates){let ht=ie.data.subarray(Ce*tt/ie.data.BYTES_PER_ELEMENT,(Ce+1)*tt/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Ce,ie.width,ie.height,1,me,ht)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,se.depth,me,ie.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,re,ie.width,ie.height,se.depth,0,ie.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else be?We&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,se.depth,me,k,ie.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,re,ie.width,ie.height,se.depth,0,me,k,ie.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{be&&Se&&t.texStorage2D(i.TEXTURE_2D,et,re,Te[0].width,Te[0].height);for(let he=0,ke=Te.length;he<ke;he++)ie=Te[he],E.format!==cs?me!==null?be?We&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,ie.data):t.compressedTexImage2D(i.TEXTURE_2D,he,re,ie.width,ie.height,0,ie.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):be?We&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ie.width,ie.height,me,k,ie.data):t.texImage2D(i.TEXTURE_2D,he,re,ie.width,ie.height,0,me,k,ie.data)}else if(E.isDataArrayTexture)if(be){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,re,se.width,se.height,se.depth),We)if(E.layerUpdates.size>0){let he=Bp(se.width,se.height,E.format,E.type);for(let ke of E.layerUpdates){let tt=se.data.subarray(ke*he/se.data.BYTES_PER_ELEMENT,(ke+1)*he/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,me,k,tt)}E.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,me,k,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,me,k,se.data);else if(E.isData3DTexture)be?(Se&&t.texStorage3D(i.TEXTURE_3D,et,re,se.width,se.height,se.depth),We&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,me,k,se.data)):t.texImage3D(i.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,me,k,se.data);else if(E.isFramebufferTexture){if(Se)if(be)t.texStorage2D(i.TEXTURE_2D,et,re,se.width,se.height);else{let he=se.width,ke=se.height;for(let tt=0;tt<et;tt++)t.texImage2D(i.TEXTURE_2D,tt,re,he,ke,0,me,k,null),he>>=1,ke>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),se.parentNode!==he){he.appendChild(se),u.add(E),he.onpaint=ke=>{let tt=ke.changedElements;for(let Ce of u)tt.includes(Ce.image)&&(Ce.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let tt=i.RGBA,Ce=i.RGBA,ht=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Ce,ht,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(be&&Se){let he=$e(Te[0]);t.texStorage2D(i.TEXTURE_2D,et,re,he.width,he.height)}for(let he=0,ke=Te.length;he<ke;he++)ie=Te[he],be?We&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,me,k,ie):t.texImage2D(i.TEXTURE_2D,he,re,me,k,ie);E.generateMipmaps=!1}else if(be){if(Se){let he=$e(se);t.texStorage2D(i.TEXTURE_2D,et,re,he.width,he.height)}We&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,k,se)}else t.texImage2D(i.TEXTURE_2D,0,re,me,k,se);_(E)&&E.mipmapsAutoUpdate===!0&&y(fe),ye.__version=ve.version,E.onUpdate&&E.onUpdate(E)}D.__version=E.version}function bn(D,E,X){if(E.image.length!==6)return;let fe=at(D,E),oe=E.source;t.bindTexture(i.TEXTURE_CUBE_MAP,D.__webglTexture,i.TEXTURE0+X);let ve=n.get(oe);if(oe.version!==ve.__version||fe===!0){t.activeTexture(i.TEXTURE0+X);let ye=yt.getPrimaries(yt.workingColorSpace),ne=E.colorSpace===or?null:yt.getPrimaries(E.colorSpace),se=E.colorSpace===or||ye===ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let me=E.isCompressedTexture||E.image[0].isCompressedTexture,k=E.image[0]&&E.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!me&&!k?re[Ce]=x(E.image[Ce],!0,s.maxCubemapSize):re[Ce]=k?E.image[Ce].image:E.image[Ce],re[Ce]=Ve(E,re[Ce]);let ie=re[0],Te=r.convert(E.format,E.colorSpace),be=r.convert(E.type),Se=M(E.internalFormat,Te,be,E.normalized,E.colorSpace),We=E.isVideoTexture!==!0,et=ve.__version===void 0||fe===!0,he=oe.dataReady,ke=S(E,ie);ct(i.TEXTURE_CUBE_MAP,E);let tt;if(E.isDepthTexture){if(Se=v(E.format===rr,E.type),et)if(We)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,ie.width,ie.height,0,Te,be,null)}else if(me){We&&et&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,Se,ie.width,ie.height);for(let Ce=0;Ce<6;Ce++){tt=re[Ce].mipmaps;for(let ht=0;ht<tt.length;ht++){let Yt=tt[ht];E.format!==cs?Te!==null?We?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,0,0,Yt.width,Yt.height,Te,Yt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,Se,Yt.width,Yt.height,0,Yt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,0,0,Yt.width,Yt.height,Te,be,Yt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,Se,Yt.width,Yt.height,0,Te,be,Yt.data)}}}else{if(tt=E.mipmaps,We&&et){tt.length>0&&ke++;let Ce=$e(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,Se,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(k){We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,Te,be,re[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,re[Ce].width,re[Ce].height,0,Te,be,re[Ce].data);for(let ht=0;ht<tt.length;ht++){let oi=tt[ht].image[Ce].image;We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,0,0,oi.width,oi.height,Te,be,oi.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,Se,oi.width,oi.height,0,Te,be,oi.data)}}else{We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Te,be,re[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,Te,be,re[Ce]);for(let ht=0;ht<tt.length;ht++){let Yt=tt[ht];We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,0,0,Te,be,Yt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,Se,Te,be,Yt.image[Ce])}}}_(E)&&E.mipmapsAutoUpdate===!0&&y(i.TEXTURE_CUBE_MAP),ve.__version=oe.version,E.onUpdate&&E.onUpdate(E)}D.__version=E.version}function Ot(D,E,X,fe,oe,ve){let ye=r.convert(X.format,X.colorSpace),ne=r.convert(X.type),se=M(X.internalFormat,ye,ne,X.normalized,X.colorSpace),me=n.get(E),k=n.get(X);if(k.__renderTarget=E,!me.__hasExternalTextures){let re=Math.max(1,E.width>>ve),ie=Math.max(1,E.height>>ve);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,ve,se,re,ie,E.depth,0,ye,ne,null):t.texImage2D(oe,ve,se,re,ie,0,ye,ne,null)}t.bindFramebuffer(i.FRAMEBUFFER,D),Ee(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,fe,oe,k.__webglTexture,0,lt(E)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,fe,oe,k.__webglTexture,ve),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Nn(D,E,X){if(i.bindRenderbuffer(i.RENDERBUFFER,D),E.depthBuffer){let fe=E.depthTexture,oe=fe&&fe.isDepthTexture?fe.type:null,ve=v(E.stencilBuffer,oe),ye=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ee(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(E),ve,E.width,E.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(E),ve,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,ve,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ye,i.RENDERBUFFER,D)}else{let fe=E.textures;for(let oe=0;oe<fe.length;oe++){let ve=fe[oe],ye=r.convert(ve.format,ve.colorSpace),ne=r.convert(ve.type),se=M(ve.internalFormat,ye,ne,ve.normalized,ve.colorSpace);Ee(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,lt(E),se,E.width,E.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,lt(E),se,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,se,E.width,E.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function wt(D,E,X){let fe=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,D),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(E.depthTexture);oe.__renderTarget=E;let ve=fe?E.depthTexture.image[0]:E.depthTexture.image;(!oe.__webglTexture||ve.width!==E.width||ve.height!==E.height)&&(ve.width=E.width,ve.height=E.height,E.depthTexture.needsUpdate=!0),fe?xe(E.depthTexture,0):ue(E.depthTexture,0);let ye=oe.__webglTexture,ne=lt(E),se=fe?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,me=E.depthTexture.format===rr?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(E.depthTexture.format===js)Ee(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,se,ye,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,me,se,ye,0);else if(E.depthTexture.format===rr)Ee(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,se,ye,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,me,se,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Tn(D){let E=n.get(D),X=D.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==D.depthTexture){let fe=D.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),fe){let oe=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,fe.removeEventListener("dispose",oe)};fe.addEventListener("dispose",oe),E.__depthDisposeCallback=oe}E.__boundDepthTexture=fe}if(D.depthTexture&&!E.__autoAllocateDepthBuffer)if(X)for(let fe=0;fe<6;fe++)wt(E.__webglFramebuffer[fe],D,fe);else D.texture.mipmaps.length>0?wt(E.__webglFramebuffer[0],D,0):wt(E.__webglFramebuffer,D,0);else if(X){E.__webglDepthbuffer=[];for(let fe=0;fe<6;fe++)if(t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[fe]),E.__webglDepthbuffer[fe]===void 0)E.__webglDepthbuffer[fe]=i.createRenderbuffer(),Nn(E.__webglDepthbuffer[fe],D,!1);else{let oe=D.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=E.__webglDepthbuffer[fe];i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}}else if(D.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=i.createRenderbuffer(),Nn(E.__webglDepthbuffer,D,!1);else{let oe=D.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=E.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function ln(D,E,X){let fe=n.get(D);E!==void 0&&Ot(fe.__webglFramebuffer,D,D.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&Tn(D)}function xn(D){let E=D.texture,X=n.get(D),fe=n.get(E);D.addEventListener("dispose",O),C(D);let oe=D.textures,ve=D.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(fe.__webglTexture===void 0&&(fe.__webglTexture=i.createTexture()),fe.__version=E.version,o.memory.textures++),ve){X.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(E.mipmaps.length>0){X.__webglFramebuffer[ne]=[];for(let se=0;se<E.mipmaps.length;se++)X.__webglFramebuffer[ne][se]=i.createFramebuffer()}else X.__webglFramebuffer[ne]=i.createFramebuffer()}else{if(E.mipmaps.length>0){X.__webglFramebuffer=[];for(let ne=0;ne<E.mipmaps.length;ne++)X.__webglFramebuffer[ne]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(ye)for(let ne=0,se=oe.length;ne<se;ne++){let me=n.get(oe[ne]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),o.memory.textures++)}if(D.samples>0&&Ee(D)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ne=0;ne<oe.length;ne++){let se=oe[ne];X.__webglColorRenderbuffer[ne]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[ne]);let me=r.convert(se.format,se.colorSpace),k=r.convert(se.type),re=M(se.internalFormat,me,k,se.normalized,se.colorSpace,D.isXRRenderTarget===!0),ie=lt(D);i.renderbufferStorageMultisample(i.RENDERBUFFER,ie,re,D.width,D.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ne,i.RENDERBUFFER,X.__webglColorRenderbuffer[ne])}i.bindRenderbuffer(i.RENDERBUFFER,null),D.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),Nn(X.__webglDepthRenderbuffer,D,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ve){t.bindTexture(i.TEXTURE_CUBE_MAP,fe.__webglTexture),ct(i.TEXTURE_CUBE_MAP,E);for(let ne=0;ne<6;ne++)if(E.mipmaps.length>0)for(let se=0;se<E.mipmaps.length;se++)Ot(X.__webglFramebuffer[ne][se],D,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else Ot(X.__webglFramebuffer[ne],D,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);_(E)?y(i.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let ne=0,se=oe.length;ne<se;ne++){let me=oe[ne],k=n.get(me),re=i.TEXTURE_2D;(D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(re=D.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,k.__webglTexture),ct(re,me),Ot(X.__webglFramebuffer,D,me,i.COLOR_ATTACHMENT0+ne,re,0),_(me)&&y(re)}t.unbindTexture()}else{let ne=i.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ne=D.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,fe.__webglTexture),ct(ne,E),E.mipmaps.length>0)for(let se=0;se<E.mipmaps.length;se++)Ot(X.__webglFramebuffer[se],D,E,i.COLOR_ATTACHMENT0,ne,se);else Ot(X.__webglFramebuffer,D,E,i.COLOR_ATTACHMENT0,ne,0);_(E)?y(ne):E.mipmaps.length>0&&i.texParameteri(ne,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}D.depthBuffer&&Tn(D)}function B(D){let E=D.textures;for(let X=0,fe=E.length;X<fe;X++){let oe=E[X];if(_(oe)&&oe.mipmapsAutoUpdate===!0){let ve=T(D),ye=n.get(oe).__webglTexture;t.bindTexture(ve,ye),y(ve),t.unbindTexture()}}}let Pe=[];function je(D){if(D.samples>0){if(Ee(D)===!1){let E=D.textures,X=D.width,fe=D.height,oe=i.COLOR_BUFFER_BIT,ve=D.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=n.get(D),ne=E.length>1;if(ne)for(let me=0;me<E.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),D.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let me=0;me<E.length;me++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),ne){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let k=n.get(E[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,k,0)}i.blitFramebuffer(0,0,X,fe,0,0,X,fe,oe,i.NEAREST),l===!0&&(Pe.length=0,Pe.push(i.COLOR_ATTACHMENT0+me),D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&Pe.push(ve),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ne)for(let me=0;me<E.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let k=n.get(E[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,k,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&l){let E=D.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[E])}}}function lt(D){return Math.min(s.maxSamples,D.samples)}function Ee(D){let E=n.get(D);return D.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function zt(D){let E=o.render.frame;h.get(D)!==E&&(h.set(D,E),D.update())}function Ve(D,E){let X=D.colorSpace,fe=D.format,oe=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||X!==il&&X!==or&&(yt.getTransfer(X)===Pt?(fe!==cs||oe!==wi)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",X)),E}function $e(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=ce,this.resetTextureUnits=ee,this.getTextureUnits=te,this.setTextureUnits=de,this.setTexture2D=ue,this.setTexture2DArray=ge,this.setTexture3D=Me,this.setTextureCube=xe,this.rebindTextures=ln,this.setupRenderTarget=xn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=je,this.setupDepthRenderbuffer=Tn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=Ee,this.dispose=G}function $A(i,e){function t(n,s=or){let r,o=yt.getTransfer(s);if(n===wi)return i.UNSIGNED_BYTE;if(n===Xh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===qh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===wp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Sp)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===yp)return i.BYTE;if(n===_p)return i.SHORT;if(n===ca)return i.UNSIGNED_SHORT;if(n===Wh)return i.INT;if(n===Fi)return i.UNSIGNED_INT;if(n===Yi)return i.FLOAT;if(n===ls)return i.HALF_FLOAT;if(n===Mp)return i.ALPHA;if(n===Ep)return i.RGB;if(n===cs)return i.RGBA;if(n===js)return i.DEPTH_COMPONENT;if(n===rr)return i.DEPTH_STENCIL;if(n===$h)return i.RED;if(n===Yh)return i.RED_INTEGER;if(n===Nr)return i.RG;if(n===jh)return i.RG_INTEGER;if(n===Zh)return i.RGBA_INTEGER;if(n===Bl||n===zl||n===Hl||n===Vl)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Bl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===zl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Hl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Vl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Bl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===zl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Hl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Vl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Jh||n===Kh||n===Qh||n===eu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Jh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Kh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Qh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===eu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===tu||n===nu||n===iu||n===su||n===ru||n===Gl||n===ou)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===tu||n===nu)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===iu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===su)return r.COMPRESSED_R11_EAC;if(n===ru)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Gl)return r.COMPRESSED_RG11_EAC;if(n===ou)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===au||n===lu||n===cu||n===hu||n===uu||n===fu||n===du||n===pu||n===mu||n===gu||n===bu||n===xu||n===vu||n===yu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===au)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===lu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===cu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===hu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===uu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===fu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===du)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===pu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===mu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===gu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===bu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===xu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===vu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===yu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===_u||n===wu||n===Su)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===_u)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===wu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Su)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Mu||n===Eu||n===Wl||n===Tu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Mu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Eu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Wl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Tu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===no?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var YA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,jA=`
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

}`,Yp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new pl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new _i({vertexShader:YA,fragmentShader:jA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Lt(new El(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},jp=class extends ss{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,p=null,b=typeof XRWebGLBinding<"u",m=new Yp,g={},x=t.getContextAttributes(),_=null,y=null,T=[],M=[],v=new we,S=null,C=null,P=new gn;P.viewport=new It;let L=new gn;L.viewport=new It;let O=[P,L],z=new Bh,U=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let ue=T[K];return ue===void 0&&(ue=new Qo,T[K]=ue),ue.getTargetRaySpace()},this.getControllerGrip=function(K){let ue=T[K];return ue===void 0&&(ue=new Qo,T[K]=ue),ue.getGripSpace()},this.getHand=function(K){let ue=T[K];return ue===void 0&&(ue=new Qo,T[K]=ue),ue.getHandSpace()};function q(K){let ue=M.indexOf(K.inputSource);if(ue===-1)return;let ge=T[ue];ge!==void 0&&(ge.update(K.inputSource,K.frame,c||o),ge.dispatchEvent({type:K.type,data:K.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ae);for(let K=0;K<T.length;K++){let ue=M[K];ue!==null&&(M[K]=null,T[K].disconnect(ue))}U=null,G=null,m.reset();for(let K in g)delete g[K];if(e.setRenderTarget(_),d=null,f=null,u=null,s=null,y=null,ce.stop(),n.isPresenting=!1,e.setPixelRatio(S),e.setSize(v.width,v.height,!1),C!==null){let K=C.camera;K.fov=C.fov,K.zoom=C.zoom,K.updateProjectionMatrix(),C=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,n.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,n.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&b&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(_=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ae),x.xrCompatible!==!0&&await t.makeXRCompatible(),S=e.getPixelRatio(),e.getSize(v),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Me=null,xe=null;x.depth&&(xe=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=x.stencil?rr:js,Me=x.stencil?no:Fi);let Ge={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(Ge),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),y=new $n(f.textureWidth,f.textureHeight,{format:cs,type:wi,depthTexture:new os(f.textureWidth,f.textureHeight,Me,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ge={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),y=new $n(d.framebufferWidth,d.framebufferHeight,{format:cs,type:wi,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ce.setContext(s),ce.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ae(K){for(let ue=0;ue<K.removed.length;ue++){let ge=K.removed[ue],Me=M.indexOf(ge);Me>=0&&(M[Me]=null,T[Me].disconnect(ge))}for(let ue=0;ue<K.added.length;ue++){let ge=K.added[ue],Me=M.indexOf(ge);if(Me===-1){for(let Ge=0;Ge<T.length;Ge++)if(Ge>=M.length){M.push(ge),Me=Ge;break}else if(M[Ge]===null){M[Ge]=ge,Me=Ge;break}if(Me===-1)break}let xe=T[Me];xe&&xe.connect(ge)}}function Y(K,ue){ue===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(ue.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let ue=K.near,ge=K.far;m.texture!==null&&(m.depthNear>0&&(ue=m.depthNear),m.depthFar>0&&(ge=m.depthFar)),z.near=L.near=P.near=ue,z.far=L.far=P.far=ge,(U!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),U=z.near,G=z.far),z.layers.mask=K.layers.mask|6,P.layers.mask=z.layers.mask&-5,L.layers.mask=z.layers.mask&-3;let Me=K.parent,xe=z.cameras;Y(z,Me);for(let Ge=0;Ge<xe.length;Ge++)Y(xe[Ge],Me);z.projectionMatrix.copy(P.projectionMatrix),z.projectionMatrixInverse.copy(P.projectionMatrixInverse),C===null&&K.isPerspectiveCamera&&(C={camera:K,fov:K.fov,zoom:K.zoom}),ee(K,z,Me)};function ee(K,ue,ge){ge===null?K.matrix.copy(ue.matrixWorld):(K.matrix.copy(ge.matrixWorld),K.matrix.invert(),K.matrix.multiply(ue.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(ue.projectionMatrix),K.projectionMatrixInverse.copy(ue.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=Zo*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(K){l=K,f!==null&&(f.fixedFoveation=K),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=K)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(K){return g[K]};let te=null;function de(K,ue){if(h=ue.getViewerPose(c||o),p=ue,h!==null){let ge=h.views;d!==null&&(e.setRenderTargetFramebuffer(y,d.framebuffer),e.setRenderTarget(y));let Me=!1;ge.length!==z.cameras.length&&(z.cameras.length=0,Me=!0);for(let He=0;He<ge.length;He++){let ct=ge[He],at=null;if(d!==null)at=d.getViewport(ct);else{let en=u.getViewSubImage(f,ct);at=en.viewport,He===0&&(e.setRenderTargetTextures(y,en.colorTexture,en.depthStencilTexture),e.setRenderTarget(y))}let Ze=O[He];Ze===void 0&&(Ze=new gn,Ze.layers.enable(He),Ze.viewport=new It,O[He]=Ze),Ze.matrix.fromArray(ct.transform.matrix),Ze.matrix.decompose(Ze.position,Ze.quaternion,Ze.scale),Ze.projectionMatrix.fromArray(ct.projectionMatrix),Ze.projectionMatrixInverse.copy(Ze.projectionMatrix).invert(),Ze.viewport.set(at.x,at.y,at.width,at.height),He===0&&(z.matrix.copy(Ze.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Me===!0&&z.cameras.push(Ze)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){u=n.getBinding();let He=u.getDepthInformation(ge[0]);He&&He.isValid&&He.texture&&m.init(He,s.renderState)}if(xe&&xe.includes("camera-access")&&b){e.state.unbindTexture(),u=n.getBinding();for(let He=0;He<ge.length;He++){let ct=ge[He].camera;if(ct){let at=g[ct];at||(at=new pl,g[ct]=at);let Ze=u.getCameraImage(ct);at.sourceTexture=Ze}}}}for(let ge=0;ge<T.length;ge++){let Me=M[ge],xe=T[ge];Me!==null&&xe!==void 0&&xe.update(Me,ue,c||o)}te&&te(K,ue),ue.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ue}),p=null}let ce=new Rx;ce.setAnimationLoop(de),this.setAnimationLoop=function(K){te=K},this.dispose=function(){}}},ZA=new xt,kx=new Qe;kx.set(-1,0,0,0,1,0,0,0,1);function JA(i,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Fp(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,x,_,y){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),f(m,g),g.isMeshPhysicalMaterial&&d(m,g,y)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),b(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,x,_):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===gi&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===gi&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let x=e.get(g),_=x.envMap,y=x.envMapRotation;_&&(m.envMap.value=_,m.envMapRotation.value.setFromMatrix4(ZA.makeRotationFromEuler(y)).transpose(),_.isCubeTexture&&_.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(kx),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,x,_){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*x,m.scale.value=_*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function f(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function d(m,g,x){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===gi&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function b(m,g){let x=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function KA(i,e,t,n){let s={},r={};function o(x,_){let y=_.program;n.uniformBlockBinding(x,y,s[x.id])}function a(x,_){let y=s[x.id];y===void 0&&(p(x),y=l(x),s[x.id]=y,x.addEventListener("dispose",m));let T=_.program;n.updateUBOMapping(x,T);let M=e.render.frame;r[x.id]!==M&&(c(x),r[x.id]=M)}function l(x){let _=i.createBuffer(),y=x.__size,T=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,_),i.bufferData(i.UNIFORM_BUFFER,y,T),i.bindBuffer(i.UNIFORM_BUFFER,null),_}function c(x){let _=s[x.id],y=x.uniforms,T=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,_);for(let M=0,v=y.length;M<v;M++){let S=y[M];if(Array.isArray(S))for(let C=0,P=S.length;C<P;C++)h(S[C],M,C,T);else h(S,M,0,T)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,_,y,T){if(f(x,_,y,T)===!0){let M=x.__offset,v=x.value;if(Array.isArray(v)){let S=0;for(let C=0;C<v.length;C++){let P=v[C],L=b(P,!0);u(P,x.__data,S),S+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,M,x.__data)}}function u(x,_,y){typeof x=="number"||typeof x=="boolean"?_[y]=x:x.isMatrix3?(_[y]=x.elements[0],_[y+1]=x.elements[1],_[y+2]=x.elements[2],_[y+3]=0,_[y+4]=x.elements[3],_[y+5]=x.elements[4],_[y+6]=x.elements[5],_[y+7]=0,_[y+8]=x.elements[6],_[y+9]=x.elements[7],_[y+10]=x.elements[8],_[y+11]=0):ArrayBuffer.isView(x)?_.set(x.subarray(0,_.length-y),y):x.toArray(_,y)}function f(x,_,y,T){let M=x.value,v=_+"_"+y;if(Array.isArray(M)){T[v]===void 0&&(T[v]=[]);let S=T[v],C=!1;for(let P=0;P<M.length;P++)d(M[P],S,P)===!0&&(C=!0);return C}return d(M,T,v)}function d(x,_,y){if(_[y]===void 0)return typeof x=="number"||typeof x=="boolean"?_[y]=x:ArrayBuffer.isView(x)?_[y]=x.slice():_[y]=x.clone(),!0;{let T=_[y];if(typeof x=="number"||typeof x=="boolean"){if(T!==x)return _[y]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(T.equals(x)===!1)return T.copy(x),!0}}return!1}function p(x){let _=x.uniforms,y=0,T=16;for(let v=0,S=_.length;v<S;v++){let C=Array.isArray(_[v])?_[v]:[_[v]];for(let P=0,L=C.length;P<L;P++){let O=C[P],z=Array.isArray(O.value)?O.value:[O.value],U=Array.isArray(_[v])||Array.isArray(O.value),G=y;for(let H=0,ae=z.length;H<ae;H++){let Y=z[H],ee=b(Y,U),te=y%T,de=te%ee.boundary,ce=te+de;y+=de,ce!==0&&T-ce<ee.storage&&(y+=T-ce),H===0&&(G=y),y+=ee.storage}let q=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new q((y-G)/Float32Array.BYTES_PER_ELEMENT),O.__offset=G}}let M=y%T;return M>0&&(y+=T-M),x.__size=y,x.__cache={},this}function b(x,_){let y={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(y.boundary=4,y.storage=4):x.isVector2?(y.boundary=8,y.storage=8):x.isVector3||x.isColor?(y.boundary=16,y.storage=12):x.isVector4?(y.boundary=16,y.storage=16):x.isMatrix3?(y.boundary=16,y.storage=48):x.isMatrix4?(y.boundary=16,y.storage=64):x.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(y.boundary=16,y.storage=x.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",x),_===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function m(x){let _=x.target;_.removeEventListener("dispose",m),i.deleteBuffer(s[_.id]),delete s[_.id],delete r[_.id]}function g(){for(let x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var QA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ps=null;function e2(){return Ps===null&&(Ps=new Ks(QA,16,16,Nr,ls),Ps.name="DFG_LUT",Ps.minFilter=pi,Ps.magFilter=pi,Ps.wrapS=Ss,Ps.wrapT=Ss,Ps.generateMipmaps=!1,Ps.needsUpdate=!0),Ps}var Lu=class{constructor(e={}){let{canvas:t=Zb(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=wi}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let b=d,m=new Set([Zh,jh,Yh]),g=new Set([wi,Fi,ca,no,Xh,qh]),x=new Uint32Array(4),_=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},T=null,M=null,v=[],S=[],C=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,L=!1,O=null,z=null,U=null,G=null;this._outputColorSpace=fi;let q=0,H=0,ae=null,Y=-1,ee=null,te=new It,de=new It,ce=null,K=new Xe(0),ue=0,ge=t.width,Me=t.height,xe=1,Ge=null,it=null,He=new It(0,0,ge,Me),ct=new It(0,0,ge,Me),at=!1,Ze=new Rr,en=new gh,Xt=!1,bn=!1,Ot=new xt,Nn=new I,wt=new It,Tn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ln=!1;function xn(){return ae===null?xe:1}let B=n;function Pe(R,V){return t.getContext(R,V)}let je,lt,Ee,zt,Ve,$e,D,E,X,fe,oe,ve,ye,ne,se,me,k,re,ie,Te,be,Se,We;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),B===null){let V="webgl2";if(B=Pe(V,R),B===null)throw Pe(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(R){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),nt("WebGLRenderer: "+R.message),R}function et(){je=new uT(B),je.init(),be=new $A(B,je),lt=new eT(B,je,e,be),Ee=new XA(B,je),lt.reversedDepthBuffer&&f&&Ee.buffers.depth.setReversed(!0),z=B.createFramebuffer(),U=B.createFramebuffer(),G=B.createFramebuffer(),zt=new pT(B),Ve=new IA,$e=new qA(B,je,Ee,Ve,lt,be,zt),D=new hT(P),E=new gS(B),Se=new KE(B,E),X=new fT(B,E,zt,Se),fe=new gT(B,X,E,Se,zt),re=new mT(B,lt,$e),se=new tT(Ve),oe=new PA(P,D,je,lt,Se,se),ve=new JA(P,Ve),ye=new DA,ne=new BA(je),k=new JE(P,D,Ee,fe,p,l),me=new WA(P,fe,lt),We=new KA(B,zt,lt,Ee),ie=new QE(B,je,zt),Te=new dT(B,je,zt),zt.programs=oe.programs,P.capabilities=lt,P.extensions=je,P.properties=Ve,P.renderLists=ye,P.shadowMap=me,P.state=Ee,P.info=zt}b!==wi&&(C=new xT(b,t.width,t.height,a,s,r));let he=new jp(P,B);this.xr=he,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let R=je.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=je.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return xe},this.setPixelRatio=function(R){R!==void 0&&(xe=R,this.setSize(ge,Me,!1))},this.getSize=function(R){return R.set(ge,Me)},this.setSize=function(R,V,Q=!0){if(he.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=R,Me=V,t.width=Math.floor(R*xe),t.height=Math.floor(V*xe),Q===!0&&(t.style.width=R+"px",t.style.height=V+"px"),C!==null&&C.setSize(t.width,t.height),this.setViewport(0,0,R,V)},this.getDrawingBufferSize=function(R){return R.set(ge*xe,Me*xe).floor()},this.setDrawingBufferSize=function(R,V,Q){ge=R,Me=V,xe=Q,t.width=Math.floor(R*Q),t.height=Math.floor(V*Q),this.setViewport(0,0,R,V)},this.setEffects=function(R){if(b===wi){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let V=0;V<R.length;V++)if(R[V].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}C.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(te)},this.getViewport=function(R){return R.copy(He)},this.setViewport=function(R,V,Q,$){R.isVector4?He.set(R.x,R.y,R.z,R.w):He.set(R,V,Q,$),Ee.viewport(te.copy(He).multiplyScalar(xn()).round())},this.getScissor=function(R){return R.copy(ct)},this.setScissor=function(R,V,Q,$){R.isVector4?ct.set(R.x,R.y,R.z,R.w):ct.set(R,V,Q,$),Ee.scissor(de.copy(ct).multiplyScalar(xn()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(R){Ee.setScissorTest(at=R)},this.setOpaqueSort=function(R){Ge=R},this.setTransparentSort=function(R){it=R},this.getClearColor=function(R){return R.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(R=!0,V=!0,Q=!0){let $=0;if(R){let j=!1;if(ae!==null){let Ae=ae.texture.format;j=m.has(Ae)}if(j){let Ae=ae.texture.type,Le=g.has(Ae),Re=k.getClearColor(),De=k.getClearAlpha(),ze=Re.r,st=Re.g,pt=Re.b;Le?(x[0]=ze,x[1]=st,x[2]=pt,x[3]=De,B.clearBufferuiv(B.COLOR,0,x)):(_[0]=ze,_[1]=st,_[2]=pt,_[3]=De,B.clearBufferiv(B.COLOR,0,_))}else $|=B.COLOR_BUFFER_BIT}V&&($|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&($|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&B.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),O=R},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),k.dispose(),ye.dispose(),ne.dispose(),$e.dispose(),Ve.dispose(),D.dispose(),fe.dispose(),X.dispose(),Se.dispose(),We.dispose(),oe.dispose(),he.dispose(),he.removeEventListener("sessionstart",cc),he.removeEventListener("sessionend",ds),Us.stop()};function ke(R){R.preventDefault(),ol("WebGLRenderer: Context Lost."),L=!0}function tt(){ol("WebGLRenderer: Context Restored."),L=!1;let R=zt.autoReset,V=me.enabled,Q=me.autoUpdate,$=me.needsUpdate,j=me.type;et(),zt.autoReset=R,me.enabled=V,me.autoUpdate=Q,me.needsUpdate=$,me.type=j}function Ce(R){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ht(R){let V=R.target;V.removeEventListener("dispose",ht),Yt(V)}function Yt(R){oi(R),Ve.remove(R)}function oi(R){let V=Ve.get(R).programs;V!==void 0&&(V.forEach(function(Q){oe.releaseProgram(Q)}),R.isShaderMaterial&&oe.releaseShaderCache(R))}this.renderBufferDirect=function(R,V,Q,$,j,Ae){V===null&&(V=Tn);let Le=j.isMesh&&j.matrixWorld.determinantAffine()<0,Re=La(R,V,Q,$,j);Ee.setMaterial($,Le);let De=Q.index,ze=1;if($.wireframe===!0){if(De=X.getWireframeAttribute(Q),De===void 0)return;ze=2}let st=Q.drawRange,pt=Q.attributes.position,Be=st.start*ze,mt=(st.start+st.count)*ze;Ae!==null&&(Be=Math.max(Be,Ae.start*ze),mt=Math.min(mt,(Ae.start+Ae.count)*ze)),De!==null?(Be=Math.max(Be,0),mt=Math.min(mt,De.count)):pt!=null&&(Be=Math.max(Be,0),mt=Math.min(mt,pt.count));let rn=mt-Be;if(rn<0||rn===1/0)return;Se.setup(j,$,Re,Q,De);let Nt,Ut=ie;if(De!==null&&(Nt=E.get(De),Ut=Te,Ut.setIndex(Nt)),j.isMesh)$.wireframe===!0?(Ee.setLineWidth($.wireframeLinewidth*xn()),Ut.setMode(B.LINES)):Ut.setMode(B.TRIANGLES);else if(j.isLine){let An=$.linewidth;An===void 0&&(An=1),Ee.setLineWidth(An*xn()),j.isLineSegments?Ut.setMode(B.LINES):j.isLineLoop?Ut.setMode(B.LINE_LOOP):Ut.setMode(B.LINE_STRIP)}else j.isPoints?Ut.setMode(B.POINTS):j.isSprite&&Ut.setMode(B.TRIANGLES);if(j.isBatchedMesh)if(je.get("WEBGL_multi_draw"))Ut.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let An=j._multiDrawStarts,Fe=j._multiDrawCounts,vn=j._multiDrawCount,vt=De?E.get(De).bytesPerElement:1,Os=Ve.get($).currentProgram.getUniforms();for(let yn=0;yn<vn;yn++)Os.setValue(B,"_gl_DrawID",yn),Ut.render(An[yn]/vt,Fe[yn])}else if(j.isInstancedMesh)Ut.renderInstances(Be,rn,j.count);else if(Q.isInstancedBufferGeometry){let An=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Fe=Math.min(Q.instanceCount,An);Ut.renderInstances(Be,rn,Fe)}else Ut.render(Be,rn)};function Ca(R,V,Q,$){O!==null&&R.isNodeMaterial&&O.setObject($,R),Xt===!0&&se.setState(R,Q,!1),R.transparent===!0&&R.side===an&&R.forceSinglePass===!1?(R.side=gi,R.needsUpdate=!0,ps(R,V,$),R.side=Rs,R.needsUpdate=!0,ps(R,V,$),R.side=an):ps(R,V,$)}this.compile=function(R,V,Q=null){Q===null&&(Q=R),O!==null&&O.renderStart(R,V,Q),M=ne.get(Q),M.init(V),S.push(M),Q.traverseVisible(function(j){j.isLight&&j.layers.test(V.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),R!==Q&&R.traverseVisible(function(j){j.isLight&&j.layers.test(V.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),M.setupLights(),O!==null&&O.updateLights(M.state.lightsArray),bn=this.localClippingEnabled,Xt=se.init(this.clippingPlanes,bn),Xt===!0&&se.setGlobalState(this.clippingPlanes,V),O!==null&&me.render(M.state.shadowsArray,Q,V);let $=new Set;return R.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Ae=j.material;if(Ae)if(Array.isArray(Ae))for(let Le=0;Le<Ae.length;Le++){let Re=Ae[Le];Ca(Re,Q,V,j),$.add(Re)}else Ca(Ae,Q,V,j),$.add(Ae)}),M=S.pop(),O!==null&&O.renderEnd(),$},this.compileAsync=function(R,V,Q=null){let $=this.compile(R,V,Q);return new Promise(j=>{function Ae(){if($.forEach(function(Le){let De=Ve.get(Le).currentProgram;(De===void 0||De.isReady())&&$.delete(Le)}),$.size===0){j(R);return}setTimeout(Ae,10)}je.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let po=null;function qf(R){po&&po(R)}function cc(){Us.stop()}function ds(){Us.start()}let Us=new Rx;Us.setAnimationLoop(qf),typeof self<"u"&&Us.setContext(self),this.setAnimationLoop=function(R){po=R,he.setAnimationLoop(R),R===null?Us.stop():Us.start()},he.addEventListener("sessionstart",cc),he.addEventListener("sessionend",ds),this.render=function(R,V){if(V!==void 0&&V.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;O!==null&&O.renderStart(R,V);let Q=he.enabled===!0&&he.isPresenting===!0,$=C!==null&&(ae===null||Q)&&C.begin(P,ae);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(C===null||C.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(V),V=he.getCamera()),R.isScene===!0&&R.onBeforeRender(P,R,V,ae),M=ne.get(R,S.length),M.init(V),M.state.textureUnits=$e.getTextureUnits(),S.push(M),Ot.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?en.setFromArrayCamera(V):Ze.setFromProjectionMatrix(Ot,Xi,V.reversedDepth),bn=this.localClippingEnabled,Xt=se.init(this.clippingPlanes,bn),T=ye.get(R,v.length),T.init(),v.push(T),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Le=P.xr.getDepthSensingMesh();Le!==null&&Fs(Le,V,-1/0,P.sortObjects)}Fs(R,V,0,P.sortObjects),T.finish(),O!==null&&O.updateLights(M.state.lightsArray),P.sortObjects===!0&&T.sort(Ge,it),ln=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,ln&&k.addToRenderList(T,R),this.info.autoReset===!0&&this.info.reset(),Xt===!0&&se.beginShadows();let j=M.state.shadowsArray;if(me.render(j,R,V),Xt===!0&&se.endShadows(),($&&C.hasRenderPass())===!1){let Le=T.opaque,Re=T.transmissive;if(M.setupLights(),V.isArrayCamera){let De=V.cameras;if(Re.length>0)for(let ze=0,st=De.length;ze<st;ze++){let pt=De[ze];Ji(Le,Re,R,pt)}ln&&k.render(R);for(let ze=0,st=De.length;ze<st;ze++){let pt=De[ze];Pa(T,R,pt,pt.viewport)}}else Re.length>0&&Ji(Le,Re,R,V),ln&&k.render(R),Pa(T,R,V)}ae!==null&&H===0&&($e.updateMultisampleRenderTarget(ae),$e.updateRenderTargetMipmap(ae)),$&&C.end(P),R.isScene===!0&&R.onAfterRender(P,R,V),Se.resetDefaultState(),Y=-1,ee=null,S.pop(),S.length>0?(M=S[S.length-1],$e.setTextureUnits(M.state.textureUnits),Xt===!0&&se.setGlobalState(P.clippingPlanes,M.state.camera)):M=null,v.pop(),v.length>0?T=v[v.length-1]:T=null,O!==null&&O.renderEnd()};function Fs(R,V,Q,$){if(R.visible===!1)return;if(R.layers.test(V.layers)){if(R.isGroup)Q=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(V);else if(R.isLight)M.pushLight(R),R.castShadow&&M.pushShadow(R);else if(R.isSprite){let Le=V.isArrayCamera?en:Ze;if(!R.frustumCulled||R.intersectsFrustum(Le)){$&&wt.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ot);let Re=fe.update(R),De=R.material;De.visible&&T.push(R,Re,De,Q,wt.z,null,V)}}else if(R.isMesh||R.isLine||R.isPoints){let Le=V.isArrayCamera?en:Ze;if(!R.frustumCulled||R.intersectsFrustum(Le)){let Re=fe.update(R),De=R.material;if($&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),wt.copy(R.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),wt.copy(Re.boundingSphere.center)),wt.applyMatrix4(R.matrixWorld).applyMatrix4(Ot)),Array.isArray(De)){let ze=Re.groups;for(let st=0,pt=ze.length;st<pt;st++){let Be=ze[st],mt=De[Be.materialIndex];mt&&mt.visible&&T.push(R,Re,mt,Q,wt.z,Be,V)}}else De.visible&&T.push(R,Re,De,Q,wt.z,null,V)}}}let Ae=R.children;for(let Le=0,Re=Ae.length;Le<Re;Le++)Fs(Ae[Le],V,Q,$)}function Pa(R,V,Q,$){let{opaque:j,transmissive:Ae,transparent:Le}=R;M.setupLightsView(Q),Xt===!0&&se.setGlobalState(P.clippingPlanes,Q),$&&Ee.viewport(te.copy($)),j.length>0&&cn(j,V,Q),Ae.length>0&&cn(Ae,V,Q),Le.length>0&&cn(Le,V,Q),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Ji(R,V,Q,$){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[$.id]===void 0){let Be=je.has("EXT_color_buffer_half_float")||je.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[$.id]=new $n(1,1,{generateMipmaps:!0,type:Be?ls:wi,minFilter:sr,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:yt.workingColorSpace})}let Ae=M.state.transmissionRenderTarget[$.id],Le=$.viewport||te;Ae.setSize(Le.z*P.transmissionResolutionScale,Le.w*P.transmissionResolutionScale);let Re=P.getRenderTarget(),De=P.getActiveCubeFace(),ze=P.getActiveMipmapLevel();P.setRenderTarget(Ae),P.getClearColor(K),ue=P.getClearAlpha(),ue<1&&P.setClearColor(16777215,.5),P.clear(),ln&&k.render(Q);let st=P.toneMapping;P.toneMapping=Cs;let pt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),M.setupLightsView($),Xt===!0&&se.setGlobalState(P.clippingPlanes,$),cn(R,Q,$),$e.updateMultisampleRenderTarget(Ae),$e.updateRenderTargetMipmap(Ae),je.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let mt=0,rn=V.length;mt<rn;mt++){let Nt=V[mt],{object:Ut,geometry:An,material:Fe,group:vn}=Nt;if(Fe.side===an&&Ut.layers.test($.layers)){let vt=Fe.side;Fe.side=gi,Fe.needsUpdate=!0,pn(Ut,Q,$,An,Fe,vn),Fe.side=vt,Fe.needsUpdate=!0,Be=!0}}Be===!0&&($e.updateMultisampleRenderTarget(Ae),$e.updateRenderTargetMipmap(Ae))}P.setRenderTarget(Re,De,ze),P.setClearColor(K,ue),pt!==void 0&&($.viewport=pt),P.toneMapping=st}function cn(R,V,Q){let $=V.isScene===!0?V.overrideMaterial:null;for(let j=0,Ae=R.length;j<Ae;j++){let Le=R[j],{object:Re,geometry:De,group:ze}=Le,st=Le.material;st.allowOverride===!0&&$!==null&&(st=$),Re.layers.test(Q.layers)&&pn(Re,V,Q,De,st,ze)}}function pn(R,V,Q,$,j,Ae){O!==null&&j.isNodeMaterial&&O.setObject(R,j),R.onBeforeRender(P,V,Q,$,j,Ae),R.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),j.onBeforeRender(P,V,Q,$,R,Ae),j.transparent===!0&&j.side===an&&j.forceSinglePass===!1?(j.side=gi,j.needsUpdate=!0,P.renderBufferDirect(Q,V,$,j,R,Ae),j.side=Rs,j.needsUpdate=!0,P.renderBufferDirect(Q,V,$,j,R,Ae),j.side=an):P.renderBufferDirect(Q,V,$,j,R,Ae),R.onAfterRender(P,V,Q,$,j,Ae)}function mn(R){let V=0;for(let Q of R)Q.texture!==null&&V++;return V}function ps(R,V,Q){V.isScene!==!0&&(V=Tn);let $=Ve.get(R),j=M.state.lights,Ae=M.state.shadowsArray,Le=j.state.version,Re=oe.getParameters(R,j.state,Ae,V,Q,M.state.lightProbeGridArray),De=oe.getProgramCacheKey(Re),ze=$.programs;$.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?V.environment:null,$.fog=V.fog;let st=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;$.envMap=D.get(R.envMap||$.environment,st),$.envMapRotation=$.environment!==null&&R.envMap===null?V.environmentRotation:R.envMapRotation,ze===void 0&&(R.addEventListener("dispose",ht),ze=new Map,$.programs=ze,$.programVariants=new Map);let pt=ze.get(De);if(pt!==void 0){if($.currentProgram===pt&&$.lightsStateVersion===Le)return Ia(R,Re),pt}else Re.uniforms=oe.getUniforms(R),O!==null&&R.isNodeMaterial&&O.build(R,Q,Re),R.onBeforeCompile(Re,P),pt=oe.acquireProgram(Re,De),ze.set(De,pt),$.uniforms=Re.uniforms;let Be=$.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Be.clippingPlanes=se.uniform),Ia(R,Re),$.needsLights=mr(R),$.lightsStateVersion=Le,$.needsLights&&(Be.ambientLightColor.value=j.state.ambient,Be.lightProbe.value=j.state.probe,Be.sunLights.value=j.state.sun,Be.sunLightShadows.value=j.state.sunShadow,Be.directionalLights.value=j.state.directional,Be.directionalLightShadows.value=j.state.directionalShadow,Be.spotLights.value=j.state.spot,Be.spotLightShadows.value=j.state.spotShadow,Be.rectAreaLights.value=j.state.rectArea,Be.ltc_1.value=j.state.rectAreaLTC1,Be.ltc_2.value=j.state.rectAreaLTC2,Be.pointLights.value=j.state.point,Be.pointLightShadows.value=j.state.pointShadow,Be.hemisphereLights.value=j.state.hemi,Be.sunShadowMatrix.value=j.state.sunShadowMatrix,Be.sunShadowCascade.value=j.state.sunShadowCascade,Be.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Be.spotLightMatrix.value=j.state.spotLightMatrix,Be.spotLightMap.value=j.state.spotLightMap,Be.pointShadowMatrix.value=j.state.pointShadowMatrix),$.numLightProbeGrids=mn(M.state.lightProbeGridArray),$.currentProgram=pt,$.uniformsList=null,pt}function Ti(R,V,Q,$,j){let Ae=Ve.get(R),Le=Ae.currentProgram.id+","+$+","+j,Re=Ae.programVariants.get(Le);return Re===void 0?(Re=ps(R,V,Q),Ae.programVariants.set(Le,Re)):(Ae.currentProgram=Re,Ae.uniformsList=null,Ae.outputColorSpace=$,Ae.toneMapping=j),Re}function pr(R){if(R.uniformsList===null){let V=R.currentProgram.getUniforms();R.uniformsList=ha.seqWithValue(V.seq,R.uniforms)}return R.uniformsList}function Ia(R,V){let Q=Ve.get(R);Q.outputColorSpace=V.outputColorSpace,Q.batching=V.batching,Q.batchingColor=V.batchingColor,Q.instancing=V.instancing,Q.instancingColor=V.instancingColor,Q.instancingMorph=V.instancingMorph,Q.skinning=V.skinning,Q.morphTargets=V.morphTargets,Q.morphNormals=V.morphNormals,Q.morphColors=V.morphColors,Q.morphTargetsCount=V.morphTargetsCount,Q.numClippingPlanes=V.numClippingPlanes,Q.numIntersection=V.numClipIntersection,Q.vertexAlphas=V.vertexAlphas,Q.vertexTangents=V.vertexTangents,Q.toneMapping=V.toneMapping}function La(R,V,Q,$,j){V.isScene!==!0&&(V=Tn),$e.resetTextureUnits();let Ae=V.fog,Le=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?V.environment:null,Re=ae===null?P.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:yt.workingColorSpace,De=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,ze=D.get($.envMap||Le,De),st=$.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,pt=!!Q.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Be=!!Q.morphAttributes.position,mt=!!Q.morphAttributes.normal,rn=!!Q.morphAttributes.color,Nt=Cs;$.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(Nt=P.toneMapping);let Ut=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,An=Ut!==void 0?Ut.length:0,Fe=Ve.get($),vn=M.state.lights;if(Xt===!0&&(bn===!0||R!==ee)){let Ft=R===ee&&$.id===Y;se.setState($,R,Ft)}let vt=!1,Os=!1;$.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==vn.state.version||j.isBatchedMesh&&Fe.batching===!1||!j.isBatchedMesh&&Fe.batching===!0||j.isBatchedMesh&&Fe.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Fe.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Fe.instancing===!1||!j.isInstancedMesh&&Fe.instancing===!0||j.isSkinnedMesh&&Fe.skinning===!1||!j.isSkinnedMesh&&Fe.skinning===!0||j.isInstancedMesh&&Fe.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Fe.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Fe.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Fe.instancingMorph===!1&&j.morphTexture!==null||Fe.envMap!==ze||$.fog===!0&&Fe.fog!==Ae||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==st||Fe.vertexTangents!==pt||Fe.morphTargets!==Be||Fe.morphNormals!==mt||Fe.morphColors!==rn||Fe.morphTargetsCount!==An||Fe.numLightProbeGrids!==mn(M.state.lightProbeGridArray)?vt=!0:(Fe.outputColorSpace!==Re||Fe.toneMapping!==Nt)&&(Os=!0):(vt=!0,Fe.__version=$.version);let yn=Fe.currentProgram;(vt===!0||Os===!0)&&(yn=Os===!0?Ti($,V,j,Re,Nt):ps($,V,j),O&&$.isNodeMaterial&&O.onUpdateProgram($,yn,Fe));let bo=!1,ms=!1,ks=!1,ft=yn.getUniforms(),hn=Fe.uniforms;if(Ee.useProgram(yn.program)&&(bo=!0,ms=!0,ks=!0),$.id!==Y&&(Y=$.id,ms=!0),bo||ee!==R){Ee.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),ft.setValue(B,"projectionMatrix",R.projectionMatrix),ft.setValue(B,"viewMatrix",R.matrixWorldInverse);let _n=ft.map.cameraPosition;_n!==void 0&&_n.setValue(B,Nn.setFromMatrixPosition(R.matrixWorld)),lt.logarithmicDepthBuffer&&ft.setValue(B,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ft.setValue(B,"isOrthographic",R.isOrthographicCamera===!0),ee!==R&&(ee=R,ms=!0,ks=!0)}if(Fe.needsLights&&(vn.state.sunShadowMap.length>0&&ft.setValue(B,"sunShadowMap",vn.state.sunShadowMap,$e),vn.state.directionalShadowMap.length>0&&ft.setValue(B,"directionalShadowMap",vn.state.directionalShadowMap,$e),vn.state.spotShadowMap.length>0&&ft.setValue(B,"spotShadowMap",vn.state.spotShadowMap,$e),vn.state.pointShadowMap.length>0&&ft.setValue(B,"pointShadowMap",vn.state.pointShadowMap,$e)),j.isSkinnedMesh){ft.setOptional(B,j,"bindMatrix"),ft.setOptional(B,j,"bindMatrixInverse");let Ft=j.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),ft.setValue(B,"boneTexture",Ft.boneTexture,$e))}j.isBatchedMesh&&(ft.setOptional(B,j,"batchingTexture"),ft.setValue(B,"batchingTexture",j._matricesTexture,$e),ft.setOptional(B,j,"batchingIdTexture"),ft.setValue(B,"batchingIdTexture",j._indirectTexture,$e),ft.setOptional(B,j,"batchingColorTexture"),j._colorsTexture!==null&&ft.setValue(B,"batchingColorTexture",j._colorsTexture,$e));let ai=Q.morphAttributes;if((ai.position!==void 0||ai.normal!==void 0||ai.color!==void 0)&&re.update(j,Q,yn),(ms||Fe.receiveShadow!==j.receiveShadow)&&(Fe.receiveShadow=j.receiveShadow,ft.setValue(B,"receiveShadow",j.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&V.environment!==null&&(hn.envMapIntensity.value=V.environmentIntensity),hn.dfgLUT!==void 0&&(hn.dfgLUT.value=e2()),ms){if(ft.setValue(B,"toneMappingExposure",P.toneMappingExposure),Fe.needsLights&&mo(hn,ks),Ae&&$.fog===!0&&ve.refreshFogUniforms(hn,Ae),ve.refreshMaterialUniforms(hn,$,xe,Me,M.state.transmissionRenderTarget[R.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Ft=y,_n=0;for(let Kn of M.state.lightProbeGridArray)Kn.texture!==null&&(Ft.textures[_n]=Kn.texture,Ft.min[_n]=Kn.boundingBox.min,Ft.max[_n]=Kn.boundingBox.max,Ft.resolution[_n]=Kn.resolution,_n++);for(let Kn in Ft)Ft[Kn].length=_n;hn.probesSH.value=Ft.textures,hn.probesMin.value=Ft.min,hn.probesMax.value=Ft.max,hn.probesResolution.value=Ft.resolution}ha.upload(B,pr(Fe),hn,$e)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(ha.upload(B,pr(Fe),hn,$e),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ft.setValue(B,"center",j.center),ft.setValue(B,"modelViewMatrix",j.modelViewMatrix),ft.setValue(B,"normalMatrix",j.normalMatrix),ft.setValue(B,"modelMatrix",j.matrixWorld),$.uniformsGroups!==void 0){let Ft=$.uniformsGroups;for(let _n=0,Kn=Ft.length;_n<Kn;_n++){let hc=Ft[_n];We.update(hc,yn),We.bind(hc,yn)}}return yn}function mo(R,V){R.ambientLightColor.needsUpdate=V,R.lightProbe.needsUpdate=V,R.sunLights.needsUpdate=V,R.sunLightShadows.needsUpdate=V,R.directionalLights.needsUpdate=V,R.directionalLightShadows.needsUpdate=V,R.pointLights.needsUpdate=V,R.pointLightShadows.needsUpdate=V,R.spotLights.needsUpdate=V,R.spotLightShadows.needsUpdate=V,R.rectAreaLights.needsUpdate=V,R.hemisphereLights.needsUpdate=V}function mr(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(R,V,Q){let $=Ve.get(R);$.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ve.get(R.texture).__webglTexture=V,Ve.get(R.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:Q,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,V){let Q=Ve.get(R);Q.__webglFramebuffer=V,Q.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(R,V=0,Q=0){ae=R,q=V,H=Q;let $=null,j=!1,Ae=!1;if(R){let Re=Ve.get(R);if(Re.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(B.FRAMEBUFFER,Re.__webglFramebuffer),te.copy(R.viewport),de.copy(R.scissor),ce=R.scissorTest,Ee.viewport(te),Ee.scissor(de),Ee.setScissorTest(ce),Y=-1;return}else if(Re.__webglFramebuffer===void 0)$e.setupRenderTarget(R);else if(Re.__hasExternalTextures)$e.rebindTextures(R,Ve.get(R.texture).__webglTexture,Ve.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let st=R.depthTexture;if(Re.__boundDepthTexture!==st){if(st!==null&&Ve.has(st)&&(R.width!==st.image.width||R.height!==st.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(R)}}let De=R.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ae=!0);let ze=Ve.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(ze[V])?$=ze[V][Q]:$=ze[V],j=!0):R.samples>0&&$e.useMultisampledRTT(R)===!1?$=Ve.get(R).__webglMultisampledFramebuffer:Array.isArray(ze)?$=ze[Q]:$=ze,te.copy(R.viewport),de.copy(R.scissor),ce=R.scissorTest}else te.copy(He).multiplyScalar(xe).floor(),de.copy(ct).multiplyScalar(xe).floor(),ce=at;if(Q!==0&&($=z),Ee.bindFramebuffer(B.FRAMEBUFFER,$)&&Ee.drawBuffers(R,$),Ee.viewport(te),Ee.scissor(de),Ee.setScissorTest(ce),j){let Re=Ve.get(R.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Re.__webglTexture,Q)}else if(Ae){let Re=V;for(let De=0;De<R.textures.length;De++){let ze=Ve.get(R.textures[De]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+De,ze.__webglTexture,Q,Re)}}else if(R!==null&&Q!==0){let Re=Ve.get(R.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Re.__webglTexture,Q)}Y=-1};function go(R){let V=Ve.get(R);return(V.__readFormat!==R.format||V.__readType!==R.type)&&(V.__readFormat=R.format,V.__readType=R.type,V.__formatReadable=lt.textureFormatReadable(R.format),V.__typeReadable=lt.textureTypeReadable(R.type)),V}this.readRenderTargetPixels=function(R,V,Q,$,j,Ae,Le,Re=0){if(!(R&&R.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=Ve.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){Ee.bindFramebuffer(B.FRAMEBUFFER,De);try{let ze=R.textures[Re],st=ze.format,pt=ze.type;R.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Re);let Be=go(ze);if(Be.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=R.width-$&&Q>=0&&Q<=R.height-j&&B.readPixels(V,Q,$,j,be.convert(st),be.convert(pt),Ae)}finally{let ze=ae!==null?Ve.get(ae).__webglFramebuffer:null;Ee.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(R,V,Q,$,j,Ae,Le,Re=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=Ve.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(V>=0&&V<=R.width-$&&Q>=0&&Q<=R.height-j){Ee.bindFramebuffer(B.FRAMEBUFFER,De);let ze=R.textures[Re],st=ze.format,pt=ze.type;R.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Re);let Be=go(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.bufferData(B.PIXEL_PACK_BUFFER,Ae.byteLength,B.STREAM_READ),B.readPixels(V,Q,$,j,be.convert(st),be.convert(pt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let rn=ae!==null?Ve.get(ae).__webglFramebuffer:null;Ee.bindFramebuffer(B.FRAMEBUFFER,rn);let Nt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Kb(B,Nt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ae),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(mt),B.deleteSync(Nt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,V=null,Q=0){let $=Math.pow(2,-Q),j=Math.floor(R.image.width*$),Ae=Math.floor(R.image.height*$),Le=V!==null?V.x:0,Re=V!==null?V.y:0;$e.setTexture2D(R,0),B.copyTexSubImage2D(B.TEXTURE_2D,Q,0,0,Le,Re,j,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(R,V,Q=null,$=null,j=0,Ae=0){let Le,Re,De,ze,st,pt,Be,mt,rn,Nt=R.isCompressedTexture?R.mipmaps[Ae]:R.image;if(Q!==null)Le=Q.max.x-Q.min.x,Re=Q.max.y-Q.min.y,De=Q.isBox3?Q.max.z-Q.min.z:1,ze=Q.min.x,st=Q.min.y,pt=Q.isBox3?Q.min.z:0;else{let ft=Math.pow(2,-j);Le=Math.floor(Nt.width*ft),Re=Math.floor(Nt.height*ft),R.isDataArrayTexture?De=Nt.depth:R.isData3DTexture?De=Math.floor(Nt.depth*ft):De=1,ze=0,st=0,pt=0}$!==null?(Be=$.x,mt=$.y,rn=$.z):(Be=0,mt=0,rn=0);let Ut=be.convert(V.format),An=be.convert(V.type),Fe;V.isData3DTexture?($e.setTexture3D(V,0),Fe=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?($e.setTexture2DArray(V,0),Fe=B.TEXTURE_2D_ARRAY):($e.setTexture2D(V,0),Fe=B.TEXTURE_2D),Ee.activeTexture(B.TEXTURE0),Ee.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),Ee.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Ee.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let vn=Ee.getParameter(B.UNPACK_ROW_LENGTH),vt=Ee.getParameter(B.UNPACK_IMAGE_HEIGHT),Os=Ee.getParameter(B.UNPACK_SKIP_PIXELS),yn=Ee.getParameter(B.UNPACK_SKIP_ROWS),bo=Ee.getParameter(B.UNPACK_SKIP_IMAGES);Ee.pixelStorei(B.UNPACK_ROW_LENGTH,Nt.width),Ee.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Nt.height),Ee.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),Ee.pixelStorei(B.UNPACK_SKIP_ROWS,st),Ee.pixelStorei(B.UNPACK_SKIP_IMAGES,pt);let ms=R.isDataArrayTexture||R.isData3DTexture,ks=V.isDataArrayTexture||V.isData3DTexture;if(R.isDepthTexture){let ft=Ve.get(R),hn=Ve.get(V),ai=Ve.get(ft.__renderTarget),Ft=Ve.get(hn.__renderTarget);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,ai.__webglFramebuffer),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let _n=0;_n<De;_n++)ms&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(R).__webglTexture,j,pt+_n),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(V).__webglTexture,Ae,rn+_n)),B.blitFramebuffer(ze,st,ze+Le,st+Re,Be,mt,Be+Le,mt+Re,B.DEPTH_BUFFER_BIT,B.NEAREST);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(j!==0||R.isRenderTargetTexture||Ve.has(R)){let ft=Ve.get(R),hn=Ve.get(V);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,U),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let ai=0;ai<De;ai++)ms?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ft.__webglTexture,j,pt+ai):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ft.__webglTexture,j),ks?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,hn.__webglTexture,Ae,rn+ai):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,hn.__webglTexture,Ae),j!==0?B.blitFramebuffer(ze,st,ze+Le,st+Re,Be,mt,Be+Le,mt+Re,B.COLOR_BUFFER_BIT,B.NEAREST):ks?B.copyTexSubImage3D(Fe,Ae,Be,mt,rn+ai,ze,st,Le,Re):B.copyTexSubImage2D(Fe,Ae,Be,mt,ze,st,Le,Re);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else ks?R.isDataTexture||R.isData3DTexture?B.texSubImage3D(Fe,Ae,Be,mt,rn,Le,Re,De,Ut,An,Nt.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Fe,Ae,Be,mt,rn,Le,Re,De,Ut,Nt.data):B.texSubImage3D(Fe,Ae,Be,mt,rn,Le,Re,De,Ut,An,Nt):R.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ae,Be,mt,Le,Re,Ut,An,Nt.data):R.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ae,Be,mt,Nt.width,Nt.height,Ut,Nt.data):B.texSubImage2D(B.TEXTURE_2D,Ae,Be,mt,Le,Re,Ut,An,Nt);Ee.pixelStorei(B.UNPACK_ROW_LENGTH,vn),Ee.pixelStorei(B.UNPACK_IMAGE_HEIGHT,vt),Ee.pixelStorei(B.UNPACK_SKIP_PIXELS,Os),Ee.pixelStorei(B.UNPACK_SKIP_ROWS,yn),Ee.pixelStorei(B.UNPACK_SKIP_IMAGES,bo),Ae===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Fe),Ee.unbindTexture()},this.initRenderTarget=function(R){Ve.get(R).__webglFramebuffer===void 0&&$e.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?$e.setTextureCube(R,0):R.isData3DTexture?$e.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?$e.setTexture2DArray(R,0):$e.setTexture2D(R,0),Ee.unbindTexture()},this.resetState=function(){q=0,H=0,ae=null,Ee.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Xi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=yt._getDrawingBufferColorSpace(e),t.unpackColorSpace=yt._getUnpackColorSpace()}};var so={light:i=>wd(.12+.88*i),viridis:T0,cividis:M0,magma:A0,turbo:E0,"blue-red":i=>S0(1-i)},cr=new Set(["block","material","level","held","surface","removable_type","removable_mode"]),t2={removable_type:["#a8adb3","#d62728","#f2a33a","#59a14f","#6f9bd1"],removable_mode:["#a8adb3","#59a14f","#f2a33a","#e0662b","#a3123a"]},Hx=["#c3ac87","#86a3bd","#b98474","#93ab7d","#a091b5","#cda552","#76aca4","#bd93a8","#a3a39a","#d2bfa6"],fa=16,n2=.15,Ou="#b3b1ab",i2=/\.(x|y|z)$|^rotation$|^spin$|pressure|sigma/;function ku(i){return i2.test(i)?"blue-red":"light"}var Si=256,s2=[128,128,128],Uu=document.createElement("canvas").getContext("2d",{willReadFrequently:!0});function Zp(i){Uu.fillStyle="#000",Uu.fillStyle=i,Uu.fillRect(0,0,1,1);let[e,t,n]=Uu.getImageData(0,0,1,1).data;return[e,t,n]}function lr(i,e=""){if(e==="material")return Hx[(Math.round(i)%10+10)%10];let t=t2[e];return t?t[Math.round(i)]??t[0]:w0[(Math.round(i)%10+10)%10]}function Bx(i){let e=Math.imul(i^739982445,2246822507);return e=Math.imul(e^e>>>13,3266489909),(e^e>>>16)>>>0&fa-1}function zx(i,e){let t=n2*(2*e/(fa-1)-1);return Zp(i).map(n=>Math.round(t>0?n+t*(255-n):n*(1+t)))}var Fu=class{texture;low=0;high=1;log=!1;kinds=!1;field="";data=new Uint8Array(8*Si);constructor(){this.texture=new Ks(this.data,2*Si,1),this.texture.colorSpace=fi,this.texture.magFilter=qt,this.texture.minFilter=qt,this.paint("light")}paint(e){let t=so[e]??wd;this.fill(n=>this.toned?zx(lr(Math.floor(n/fa),"material"),n%fa):Zp(this.kinds?lr(n%250,this.field):t(n/(Si-1))))}plain(){this.fill(e=>zx(Hx[0],e%fa))}fill(e){for(let t=0;t<2*Si;t++)this.data.set([...t<Si?e(t):s2,255],4*t);this.data.set([...Zp(Ou),255],4*(2*Si-1)),this.texture.needsUpdate=!0}get toned(){return this.kinds&&this.field==="material"}get terrain(){return 1-.25/Si}tone(e){return(Bx(e)+.5)/(2*Si)}share(e){return this.log?e>0?Math.log(e/this.low)/Math.log(this.high/this.low):-1/0:(e-this.low)/(this.high-this.low)}isBeyond(e){let t=1/(Si-1);return this.share(e)<-t||this.share(e)>1+t}place(e,t){if(!Number.isFinite(e))return .75;if(this.toned)return(fa*((Math.round(e)%10+10)%10)+Bx(t)+.5)/(2*Si);if(this.kinds)return((Math.round(e)%250+250)%250+.5)/(2*Si);let n=this.share(e);return n>0?n>1&&(n=1):n=0,(n*(Si-1)+.5)/(2*Si)}css(e){let t=4*Math.round(Math.min(1,Math.max(0,e))*(Si-1));return`rgb(${this.data[t]}, ${this.data[t+1]}, ${this.data[t+2]})`}};var Vx=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"\xB5"],[1e-9,"n"]],r2=new Set(["m","m/s","m/s2","Pa","N","N/m","J","J/m","s","W"]);function Jp(i,e){if(e==="-"||e==="")return{factor:1,unit:""};if(!r2.has(e)||!(i>0)||!Number.isFinite(i))return{factor:1,unit:e};let t=Vx.find(([n])=>i>=n*.9995)??Vx.at(-1);return e.startsWith("m")&&t[0]>1?{factor:1,unit:e}:{factor:1/t[0],unit:t[1]+e}}function Bt(i,e=4){if(Number.isNaN(i))return"no number";if(!Number.isFinite(i))return i>0?"\u221E":"-\u221E";if(i===0)return"0";let t=Math.abs(i);if(t>=1e5||t<1e-4){let[n,s]=i.toExponential(Math.max(0,e-2)).split("e");return`${Number(n)}e${Number(s)}`}return String(Number(i.toPrecision(e)))}function sn(i,e,t=4){let n=Jp(Math.abs(i),e);return n.unit?`${Bt(i*n.factor,t)} ${n.unit}`:Bt(i*n.factor,t)}function Gx(i,e,t=5){if(!(e>i))return[i];let n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=n*.999)??10*s,o=[];for(let a=Math.ceil(i/r-1e-9);a*r<=e+1e-9*r;a++)o.push(a*r);return o}var o2=1e-7,a2=new I(17e-10,29e-10,23e-10);function Wx(i,e,t){let n=[],s=i.dimension===3?l2(i,e,t):null;for(let r=0;r<i.count;r++){let o=s?s(r):c2(i,r,e,t);for(let a=0;a+1<o.length;a+=2){let[l,c]=[Math.max(0,o[a]),Math.min(1,o[a+1])];c-l>o2&&n.push({from:l,to:c,block:r})}}return n.sort((r,o)=>r.from-o.from||r.to-o.to)}function l2({positions:i,corners:e,facesOf:t,faceEnds:n},s,r){let o=new I().subVectors(r,s),a=o.length(),l=new I().copy(s).addScaledVector(a2,a);o.divideScalar(a);let c=new I(1,0,0);Math.abs(o.x)>.6&&c.set(0,1,0);let h=new I().crossVectors(o,c).normalize(),u=new I().crossVectors(o,h),[f,d,p]=[[],[],[]];return b=>{let m=[];for(let g=t[b];g<t[b+1];g++){let[x,_]=[n[g],n[g+1]-n[g]],[y,T,M,v]=[!1,!1,!1,!1];for(let C=0;C<_;C++){let P=3*e[x+C],[L,O,z]=[i[P]-l.x,i[P+1]-l.y,i[P+2]-l.z];f[C]=L*h.x+O*h.y+z*h.z,d[C]=L*u.x+O*u.y+z*u.z,p[C]=L*o.x+O*o.y+z*o.z,f[C]>=0&&(T=!0),f[C]<=0&&(y=!0),d[C]>=0&&(v=!0),d[C]<=0&&(M=!0)}if(!y||!T||!M||!v)continue;let S=(C,P)=>f[C]*d[P]-d[C]*f[P];for(let C=1;C+1<_;C++){let[P,L,O]=[S(C,C+1),S(C+1,0),S(0,C)],z=P+L+O;z===0||!(P>=0&&L>=0&&O>=0||P<=0&&L<=0&&O<=0)||m.push((P*p[0]+L*p[C]+O*p[C+1])/(z*a))}}return m.sort((g,x)=>g-x)}}function c2({positions:i,corners:e,facesOf:t,faceEnds:n},s,r,o){let a=[],[l,c]=[o.x-r.x,o.y-r.y];for(let h=t[s];h<t[s+1];h++){let[u,f]=[n[h],n[h+1]];for(let d=u;d<f;d++){let[p,b]=[3*e[d],3*e[d+1<f?d+1:u]],m=M=>l*(i[M+1]-r.y)-c*(i[M]-r.x),[g,x]=[m(p),m(b)];if(g>=0==x>=0)continue;let _=g/(g-x),[y,T]=[i[p]+_*(i[b]-i[p]),i[p+1]+_*(i[b+1]-i[p+1])];a.push(((y-r.x)*l+(T-r.y)*c)/(l*l+c*c))}}return a.sort((h,u)=>h-u)}var Bu=class{object=new Vt;line;ends;constructor(){let e={color:Kp,depthTest:!1,transparent:!0};this.line=new ea(new gt,new qi(e)),this.ends=new tr(new gt,new Ts({...e,size:9,sizeAttenuation:!1}));for(let t of[this.line,this.ends])t.frustumCulled=!1,t.renderOrder=6,this.object.add(t);this.object.visible=!1}draw(e,t){this.object.visible=e.length>0;let n=e.flatMap(s=>[s.x,s.y,t?.6:s.z]);for(let s of[this.line,this.ends])s.geometry.dispose(),s.geometry.setAttribute("position",new Ke(n,3))}},Kp="#e0007a";var Xx=new WeakMap;function h2(i){let e=Xx.get(i);if(!e){e=new Map;let{twins:t,blockOf:n,count:s}=i;for(let r=0;r<t.length;r+=2){let o=n[t[r]],a=n[t[r+1]];e.set(Math.min(o,a)*s+Math.max(o,a),r)}Xx.set(i,e)}return e}function zu(i,e){let t=h2(i),{twins:n,faceEnds:s,corners:r,positions:o,count:a}=i,l=[],c=[];return e.forEach(([h,u],f)=>{let d=t.get(Math.min(h,u)*a+Math.max(h,u));if(d===void 0)return;let p=n[d],b=s[p],m=s[p+1];for(let g=b+1;g+1<m;g++){for(let x of[r[b],r[g],r[g+1]])l.push(o[3*x],o[3*x+1],o[3*x+2]);c.push(f)}}),{points:l,pair:c}}var Qp=4e3,hr=[{name:"touching",colour:"#4b8fd6"},{name:"sliding",colour:"#f0a020"},{name:"softened",colour:"#3aa88f"},{name:"broken",colour:"#e0483e"},{name:"broken in tension",colour:"#d62728"},{name:"broken in shear",colour:"#2c4fb8"},{name:"broken and open",colour:"#b05cd0"},{name:"open",colour:"#c062a8"}],Wu=2;function u2(i){if(i){let r=new na;return r.moveTo(0,-.025).lineTo(.7,-.025).lineTo(.7,-.1).lineTo(1,0),r.lineTo(.7,.1).lineTo(.7,.025).lineTo(0,.025).closePath(),new Tl(r)}let e=new nr(.025,.025,.7,5).translate(0,.35,0),t=new ml(.09,.3,8).translate(0,.85,0),n=new gt,s=[e.toNonIndexed(),t.toNonIndexed()];for(let r of["position","normal"]){let o=s.map(l=>l.getAttribute(r).array),a=new Float32Array(o[0].length+o[1].length);a.set(o[0]),a.set(o[1],o[0].length),n.setAttribute(r,new dn(a,3))}return n.rotateZ(-Math.PI/2)}var ma=new I(1,0,0),Ur=class{constructor(e,t={}){this.flat=e;this.material=new Yn({side:an,...t})}flat;object=new Vt;mesh=null;material;set colour(e){this.material.color.set(e)}draw(e,t,n,s){this.clear();let r=t.length/3,o=[];for(let f=0;f<r;f++)Math.hypot(t[3*f],t[3*f+1],t[3*f+2])>n*.01&&Number.isFinite(e[3*f])&&o.push(f);let a=Math.max(1,Math.ceil(o.length/Qp)),l=o.filter((f,d)=>d%a===0),c=new Qs(u2(this.flat),this.material,l.length),h=new nn,u=new I;l.forEach((f,d)=>{u.fromArray(t,3*f);let p=u.length();h.position.fromArray(e,3*f),this.flat&&(h.position.z+=.5),h.quaternion.setFromUnitVectors(ma,u.divideScalar(p));let b=p/n*s,m=Math.max(b,s/3);h.scale.set(b,m,m),h.updateMatrix(),c.setMatrixAt(d,h.matrix)}),c.frustumCulled=!1,c.renderOrder=3,this.mesh=c,this.object.add(c)}clear(){this.mesh&&(this.object.remove(this.mesh),this.mesh.geometry.dispose(),this.mesh.dispose(),this.mesh=null)}},da=class{object=new Vt;geometry=new gt;points;cracks;constructor(e){this.points=new tr(this.geometry,new Ts({size:e?6:5,sizeAttenuation:!1,vertexColors:!0,depthTest:!e})),this.cracks=new Lt(new gt,new As({vertexColors:!0,side:an,flatShading:!0}));for(let t of[this.points,this.cracks])t.frustumCulled=!1,this.object.add(t);this.points.renderOrder=2,this.clear()}clear(){this.points.visible=!1,this.cracks.visible=!1}end(e){for(let t of[this.points,this.cracks])t.material.clippingPlanes=e}static count(e){let t=hr.map(()=>0);for(let n of e.u8("states"))t[n]=(t[n]??0)+1;return t}drawPoints(e,t,n){let s=e.u8("states"),r=hr.map(l=>new Xe(l.colour)),o=[],a=[];s.forEach((l,c)=>{n[l]&&(o.push(t[3*c],t[3*c+1],t[3*c+2]),a.push(...r[l].toArray()))}),this.geometry.dispose(),this.geometry.setAttribute("position",new Ke(o,3)),this.geometry.setAttribute("color",new Ke(a,3)),this.points.visible=o.length>0}drawCracks(e,t,n,s){let r=e.u8("states"),o=e.u32("blockA"),a=e.u32("blockB"),l=[],c=[];r.forEach((b,m)=>{let[g,x]=[o[m]??Jl,a[m]??Jl],_=t!==null&&(b===4||b===5);b<Wu||_||g===Jl||x===Jl||!n.isShown(g)||!n.isShown(x)||(l.push([g,x]),c.push(b))});let{points:h,pair:u}=zu(n,l),f=u.map(b=>c[b]);t&&m2(t,n,s,h,f);let d=hr.map(b=>new Xe(b.colour)),p=new Float32Array(h.length);f.forEach((b,m)=>{for(let g=0;g<3;g++)d[b].toArray(p,9*m+3*g)}),this.cracks.geometry.dispose(),this.cracks.geometry.setAttribute("position",new Ke(h,3)),this.cracks.geometry.setAttribute("color",new dn(p,3)),this.cracks.visible=h.length>0}hide(e){this[e].visible=!1}},pa=class{mesh=null;object=new Vt;material=new Yn({depthTest:!1,transparent:!0});clear(){this.mesh&&(this.object.remove(this.mesh),this.mesh.geometry.dispose(),this.mesh.dispose(),this.mesh=null)}},Hu=class extends pa{draw(e,t,n,s){this.clear();let r=e.f32("points"),o=e.f32("forces"),a=e.u8("states"),l=[e.u32("blockA"),e.u32("blockB")],c=Math.max(Math.abs(e.info.largest??0),Math.abs(e.info.smallest??0))||1,h=new Qs(new nr(.5,.5,1,6).rotateZ(-Math.PI/2),this.material,o.length),u=new nn,[f,d,p]=[new I,new I,new I],b=new Xe;o.forEach((m,g)=>{[f,d].forEach((y,T)=>{let M=l[T][g];y.fromArray(r,6*g+3*T),M<t.count&&y.add(n(M,p))}),p.subVectors(d,f);let x=p.length();u.position.addVectors(f,d).multiplyScalar(.5),x>0&&u.quaternion.setFromUnitVectors(ma,p.divideScalar(x));let _=a[g]===d2;u.scale.set(x,_?s/3:s,_?s/3:s),u.updateMatrix(),h.setMatrixAt(g,u.matrix),h.setColorAt(g,_?b.set("#444444"):p2(m/c,b))}),h.frustumCulled=!1,h.renderOrder=4,this.mesh=h,this.object.add(h)}},f2=.02,Vu=class extends pa{draw(e,t,n,s){this.clear();let r=e.f32("forces"),o=[e.u32("blockA"),e.u32("blockB")],a=e.info.longest??0,l=[],c=0;for(let p=0;3*p<r.length;p++){let b=Math.hypot(r[3*p],r[3*p+1],r[3*p+2])/a;if(!(b>f2)||!Number.isFinite(t[3*p]))continue;let m=new I().fromArray(t,3*p),g=o.flatMap(x=>n(x[p]??Jl)??[]);l.push(...g.map(x=>({from:m,to:x,share:b}))),c+=g.length>0?1:0}let h=new Qs(new nr(.5,.5,1,8).rotateZ(-Math.PI/2),this.material,l.length),u=new nn,f=new I,d=new Xe;return l.sort((p,b)=>p.share-b.share).forEach(({from:p,to:b,share:m},g)=>{f.subVectors(b,p);let x=f.length();u.position.addVectors(p,b).multiplyScalar(.5),x>0&&u.quaternion.setFromUnitVectors(ma,f.divideScalar(x)),u.scale.set(x,s*m,s*m),u.updateMatrix(),h.setMatrixAt(g,u.matrix),h.setColorAt(g,d.set("#f7c873").lerp(new Xe(em),m))}),h.frustumCulled=!1,h.renderOrder=4,this.mesh=h,this.object.add(h),c}},em="#8c1313",tm="#ff7a00",Gu=class{object=new Vt;material=new Yn({color:tm,depthTest:!1,transparent:!0,opacity:.85});build(e,t,n){for(let s of e){let r=(s.centre?[s.centre]:s.line??[]).map(o=>new I(o[0]-t[0],o[1]-t[1],o[2]-t[2]));for(let o of r)this.add(new Ml(n)).position.copy(o);for(let o=0;o+1<r.length;o++){let a=r[o+1].clone().sub(r[o]),l=this.add(new nr(n/5,n/5,a.length(),6).rotateZ(-Math.PI/2));l.position.copy(r[o]).addScaledVector(a,.5),l.quaternion.setFromUnitVectors(ma,a.normalize())}}}add(e){let t=new Lt(e,this.material);return t.renderOrder=4,this.object.add(t),t}},Kl="#1d5fd0",Ql="#d01c1c",d2=3;function p2(i,e){let t=Math.min(1,Math.abs(i));return e.set("#f4f0ea").lerp(new Xe(i<0?Kl:Ql),t)}var Jl=4294967295;function m2(i,e,t,n,s){let r=i.f32("points"),o=[i.u32("blockA"),i.u32("blockB")],[a,l]=[new I,new I];i.u8("states").forEach((c,h)=>{let u=o.map(f=>f[h]).filter(f=>f<e.count);if(u.some(f=>e.isShown(f))){l.set(0,0,0);for(let f of u)l.addScaledVector(t(f,a),1/u.length);for(let f=0;f<9;f++)n.push(r[9*h+f]+l.getComponent(f%3));s.push(c)}})}function qx(i,e,t){let n=i.f32("points").slice(),s=i.u32("blockA"),r=new I;for(let o=0;o<s.length;o++){let a=s[o];a>=e.count||(t(a,r),n[3*o]=n[3*o]+r.x,n[3*o+1]=n[3*o+1]+r.y,n[3*o+2]=n[3*o+2]+r.z)}return n}var ro=class{object;constructor(e="#ff2e88",t=5){this.object=new er(new gt,new qi({color:e,depthTest:!1,transparent:!0})),this.object.renderOrder=t,this.object.frustumCulled=!1,this.object.visible=!1}draw(e){this.object.visible=e!==null,e&&(this.object.geometry.dispose(),this.object.geometry.setAttribute("position",new dn(e,3)))}};var g2=2e4;function $x(i){let e=new $t;if(i.count===0)return e;let t=Math.max(1,Math.floor(i.count/g2)),n=[0,1,2].map(b=>{let m=new Float32Array(Math.ceil(i.count/t));for(let _=0;_<m.length;_++){let y=i.positions[3*i.offsets[_*t]+b];m[_]=Number.isFinite(y)?y:m[_-1]??0}m.sort();let g=_=>m[Math.round(_*(m.length-1))]??0,x=Math.max(.15*(g(.9975)-g(.0025)),i.size);return[g(.0025)-x,g(.9975)+x]}),{positions:s,offsets:r}=i,[[o,a],[l,c],[h,u]]=n,f=b=>{let[m,g,x]=[s[3*b],s[3*b+1],s[3*b+2]];return m>=o&&m<=a&&g>=l&&g<=c&&x>=h&&x<=u},d=[1/0,1/0,1/0],p=[-1/0,-1/0,-1/0];for(let b=0;b<i.count;b++){let[m,g]=[r[b],r[b+1]],x=m;for(;x<g&&!f(x);)x++;if(x!==g)for(let _=3*m;_<3*g;_++){let y=s[_],T=(_-3*m)%3;y<d[T]&&(d[T]=y),y>p[T]&&(p[T]=y)}}return p[0]>=d[0]&&e.set(new I(...d),new I(...p)),e}function Yx(i,e,t,n){let{rest:s,positions:r,offsets:o,middles:a}=i;for(let l=0;l<i.count;l++){let c=Math.cos(t[l])-1,h=Math.sin(t[l]),u=e[2*l],f=e[2*l+1],d=a[3*l],p=a[3*l+1];for(let b=3*o[l];b<3*o[l+1];b+=3){let m=s[b]-d,g=s[b+1]-p;r[b]=s[b]+n*(u+c*m-h*g),r[b+1]=s[b+1]+n*(f+h*m+c*g)}}}function jx(i,e,t,n,s){let{rest:r,positions:o,offsets:a,middles:l}=i;for(let c=0;c<i.count;c++){let h=3*c,u=e[h],f=e[h+1],d=e[h+2],p=t[h]*n,b=t[h+1]*n,m=t[h+2]*n,g=p===0&&b===0&&m===0,x=Math.sqrt(Math.max(0,1-p*p-b*b-m*m)),_=l[h],y=l[h+1],T=l[h+2];for(let M=3*a[c];M<3*a[c+1];M+=3){let v=u,S=f,C=d;if(!g){let P=r[M]-_,L=r[M+1]-y,O=r[M+2]-T,z=2*(b*O-m*L),U=2*(m*P-p*O),G=2*(p*L-b*P);v+=x*z+b*G-m*U,S+=x*U+m*z-p*G,C+=x*G+p*U-b*z}o[M]=r[M]+s*v,o[M+1]=r[M+1]+s*S,o[M+2]=r[M+2]+s*C}}}function Zx(i,e){let[t,n]=[i,e].map(Hn.degToRad);return[Math.sin(t)*Math.sin(n),Math.sin(t)*Math.cos(n),Math.cos(t)]}function Jx(i){let e=Hn.degToRad(i);return[-Math.sin(e),Math.cos(e),0]}function Kx(i,e,t,n){let{positions:s,offsets:r,count:o}=i,[a,l,c]=e.normal.map(u=>e.keep*u),h=e.keep*e.at;for(let u=0;u<o;u++){let f=1/0,d=-1/0;for(let p=3*r[u];p<3*r[u+1];p+=3){let b=a*s[p]+l*s[p+1]+c*s[p+2]-h;b<f&&(f=b),b>d&&(d=b)}n[u]=d<=t?0:f>=-t?1:2}}var b2=2**26;function Qx(i,e,t){let n={triangles:[],owners:[],lines:[]},s=new I(...e.normal).multiplyScalar(e.keep),r=e.keep*e.at,o=_2(s);for(let a of t){let l=new Map;for(let c=i.facesOf[a];c<i.facesOf[a+1];c++){let h=x2(i,c,s,r);if(!(h.length<2)){h.length>2&&v2(h);for(let u=0;u+1<h.length;u+=2){let[f,d]=[h[u],h[u+1]];i.dimension===2&&n.lines.push(...f.point.toArray(),...d.point.toArray());let[p,b]=f.up?[f,d]:[d,f];l.set(p.edge,{to:b.edge,point:p.point})}}}i.dimension===3&&w2(y2(l),o,a,n)}return n}function x2(i,e,t,n){let{corners:s,faceEnds:r,positions:o}=i,a=r[e],l=r[e+1],c=d=>t.x*o[3*d]+t.y*o[3*d+1]+t.z*o[3*d+2]-n,h=[],u=s[l-1],f=c(u);for(let d=a;d<l;d++){let p=s[d],b=c(p);if(f>=0!=b>=0){let[m,g,x,_]=u<p?[u,p,f,b]:[p,u,b,f],y=x/(x-_),T=new I;for(let M of[0,1,2]){let v=o[3*m+M];T.setComponent(M,v+y*(o[3*g+M]-v))}h.push({edge:m*b2+g,up:b>=0,point:T})}u=p,f=b}return h}function v2(i){let e=i[0].point,n=i.reduce((s,r)=>r.point.distanceToSquared(e)>s.point.distanceToSquared(e)?r:s).point.clone().sub(e);i.sort((s,r)=>s.point.dot(n)-r.point.dot(n))}function y2(i){let e=[];for(let t of i.keys()){let n=[],s=t;for(let r=i.get(s);r;r=i.get(s))n.push(r.point),i.delete(s),s=r.to;s===t&&n.length>2&&e.push(n)}return e}function _2(i){let t=(Math.abs(i.z)<.9?new I(0,0,1):new I(1,0,0)).cross(i).normalize();return[t,t.clone().cross(i)]}function w2(i,[e,t],n,s){let r=i.map(h=>({points:h,flat:h.map(u=>new we(u.dot(e),u.dot(t)))}));for(let{points:h}of r)h.forEach((u,f)=>s.lines.push(...u.toArray(),...h[(f+1)%h.length].toArray()));let o=(h,u,f)=>{s.triangles.push(h.x,h.y,h.z,u.x,u.y,u.z,f.x,f.y,f.z),s.owners.push(n)},a=r[0];if(a&&r.length===1&&S2(a.flat)){let{points:h}=a;for(let u=1;u+1<h.length;u++)o(h[0],h[u],h[u+1]);return}let l=r.filter(h=>Ms.area(h.flat)>0),c=r.filter(h=>Ms.area(h.flat)<0);for(let h of l){let u=l.length===1?c:c.filter(d=>M2(d.flat[0],h.flat)),f=[...h.points,...u.flatMap(d=>d.points)];for(let[d,p,b]of Ms.triangulateShape(h.flat.slice(),u.map(m=>m.flat.slice())))o(f[d],f[p],f[b])}}function S2(i){let e=i.length;for(let t=0;t<e;t++){let[n,s,r]=[i[t],i[(t+1)%e],i[(t+2)%e]],[o,a,l,c]=[s.x-n.x,s.y-n.y,r.x-s.x,r.y-s.y];if(o*c-a*l<-1e-6*Math.hypot(o,a)*Math.hypot(l,c))return!1}return!0}function M2(i,e){let t=!1;return e.forEach((n,s)=>{let r=e[(s+1)%e.length];n.y>i.y!=r.y>i.y&&i.x<n.x+(i.y-n.y)/(r.y-n.y)*(r.x-n.x)&&(t=!t)}),t}var Xu=class{object=new Vt;cast;mesh;lines;owners=[];withEdges=!1;constructor(e){let t={map:e,side:an,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1};this.mesh=new Lt(new gt,new Yn(t)),this.lines=new er(new gt,new qi({color:0,transparent:!0,opacity:.55})),this.cast=new Lt(this.mesh.geometry,new Yn({colorWrite:!1,side:an})),this.cast.frustumCulled=!1;for(let n of[this.mesh,this.lines])n.frustumCulled=!1,this.object.add(n);this.clear()}get count(){return new Set(this.owners).size}clear(){this.object.visible=!1,this.cast.visible=!1,this.owners=[]}draw(e,t,n){let{triangles:s,owners:r,lines:o}=e;this.owners=r,this.object.visible=o.length>0,this.withEdges=n,this.mesh.visible=s.length>0,this.cast.visible=this.mesh.visible;let a=new Float32Array(6*r.length);r.forEach((l,c)=>{for(let h=0;h<3;h++)a[6*c+2*h]=t[l]}),this.mesh.geometry.dispose(),this.mesh.geometry.setAttribute("position",new Ke(s,3)),this.mesh.geometry.setAttribute("uv",new dn(a,2)),this.mesh.geometry.boundingSphere=null,this.lines.geometry.dispose(),this.lines.geometry.setAttribute("position",new Ke(o,3))}fade(e){this.lines.visible=this.withEdges&&e>0,this.lines.material.opacity=.55*e}pick(e){if(!this.object.visible||!this.mesh.visible)return null;let t=e.intersectObject(this.mesh,!1)[0],n=t?.faceIndex===void 0||t.faceIndex===null?void 0:this.owners[t.faceIndex];return t&&n!==void 0?{block:n,distance:t.distance}:null}set glass(e){let{material:t}=this.mesh;t.transparent=e,t.opacity=e?.14:1,t.depthWrite=!e,t.needsUpdate=!0}dispose(){for(let e of[this.mesh,this.lines])e.geometry.dispose(),e.material.dispose()}};var qu=class{constructor(e,t){this.of=e;this.survey=t}of;survey;kept=new Map;turned=new Map;scratch=new Int32Array(64);at(e){let{faceEnds:t,facesOf:n}=this.of,s=t[n[e+1]]-t[n[e]];if(s<=64)return this.fill(e,s,this.scratch);let r=this.kept.get(e);if(r)return r;let o=this.fill(e,s,new Int32Array(s));return this.kept.set(e,o),o}fill(e,t,n){let{facesOf:s,faceEnds:r,corners:o}=this.of,[a,l]=[s[e],s[e+1]],c=r[a],h=this.survey(e)?.766:.98,u=new Float32Array(3*(l-a));for(let m=a;m<l;m++)this.normal(m,u,3*(m-a));n.fill(-1,0,t);let f=(m,g,x,_)=>{let[y,T]=[3*(g-a),3*(_-a)],v=u[y]*u[T]+u[y+1]*u[T+1]+u[y+2]*u[T+2]<h?1:0;n[m-c]=2*_+v,n[x-c]=2*g+v},{turned:d}=this,p=t>64,b=p?o.subarray(c,c+t).reduce((m,g)=>Math.min(m,g),4294967295):0;d.clear();for(let m=a;m<l;m++){let[g,x]=[r[m],r[m+1]];for(let _=g;_<x;_++){let[y,T]=[o[_],o[_+1<x?_+1:g]];if(p){let M=d.get((T-b)*4194304+(y-b));M!==void 0?f(_,m,M,this.faceOf(M,a,l)):d.set((y-b)*4194304+(T-b),_);continue}for(let M=a;M<m&&n[_-c]===-1;M++){let[v,S]=[r[M],r[M+1]];for(let C=v;C<S;C++)if(o[C]===T&&o[C+1<S?C+1:v]===y){f(_,m,C,M);break}}}}return n}faceOf(e,t,n){let{faceEnds:s}=this.of,[r,o]=[t,n];for(;r+1<o;){let a=r+o>>1;s[a]<=e?r=a:o=a}return r}normal(e,t,n){let{faceEnds:s,corners:r,rest:o}=this.of,[a,l]=[s[e],s[e+1]],c=3*r[a],[h,u,f]=[0,0,0];for(let p=a+1;p+1<l;p++){let[b,m]=[3*r[p],3*r[p+1]],[g,x,_]=[o[b]-o[c],o[b+1]-o[c+1],o[b+2]-o[c+2]],[y,T,M]=[o[m]-o[c],o[m+1]-o[c+1],o[m+2]-o[c+2]];h+=x*M-_*T,u+=_*y-g*M,f+=g*T-x*y}let d=Math.hypot(h,u,f)||1;t[n]=h/d,t[n+1]=u/d,t[n+2]=f/d}};var E2=new Ui(-1,1,1,-1,0,1),nm=class extends gt{constructor(){super(),this.setAttribute("position",new Ke([-1,3,0,-1,-1,0,3,-1,0],3)),this.setAttribute("uv",new Ke([0,2,0,0,2,0],2))}},T2=new nm,$u=class{constructor(e){this._mesh=new Lt(T2,e)}dispose(){this._mesh.geometry.dispose()}render(e){e.render(this._mesh,E2)}get material(){return this._mesh.material}set material(e){this._mesh.material=e}};var A2=2,R2=3,C2=2048,P2=1024,I2="varying vec2 place; void main() { place = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",L2=`
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
`,D2=`
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
`,im=new Ks(new Uint8Array([255,255,255,255]),1,1);im.needsUpdate=!0;function tv(i,e){i.onBeforeCompile=t=>{t.uniforms.shadeLight=e.light,t.uniforms.shadePoints=e.points,t.fragmentShader=t.fragmentShader.replace("void main() {",`uniform sampler2D shadeLight;
uniform vec2 shadePoints;
void main() {`).replace("#include <aomap_fragment>",`vec2 shade = texture2D(shadeLight, gl_FragCoord.xy / shadePoints).rg;
        reflectedLight.directDiffuse *= shade.g;
        reflectedLight.indirectDiffuse += 0.7 * abs(dot(normal, normalize(vViewPosition))) * BRDF_Lambert(diffuseColor.rgb);
        reflectedLight.indirectDiffuse *= shade.r;
        reflectedLight.directDiffuse *= 0.5 + 0.5 * shade.r;`)}}var Yu=class{constructor(e,t){this.renderer=e;this.software=t;let n=r=>{let o=new $n(r,r,{minFilter:qt,magFilter:qt});return o.depthTexture=new os(r,r,Fi),o};this.depth=n(4),this.sun=n(t?P2:C2),this.found=new $n(4,4,{minFilter:qt,magFilter:qt,depthBuffer:!1}),this.smooth=new $n(4,4,{depthBuffer:!1});let s=(r,o,a={})=>{let l=Object.fromEntries(o.map(c=>[c,{value:null}]));return new $u(new _i({vertexShader:I2,fragmentShader:r,uniforms:l,defines:a,depthTest:!1,depthWrite:!1,blending:ir}))};this.find=s(L2,["depth","sun","back","toSun","points","clip","reach","scale","lift","sunPoint","bias"],{SAMPLES:t?9:14}),this.mean=s(D2,["light","points","near"])}renderer;software;lit={light:{value:im},points:{value:new we(1,1)}};depth;found;smooth;sun;sunCamera=new Ui;own=new gn;find;mean;stale=!0;moved(){this.stale=!0}clear(){this.lit.light.value=im}draw(e,t,n,s,r){let{renderer:o,own:a,lit:l}=this,c=o.getDrawingBufferSize(l.points.value),h=this.software?R2:A2,[u,f]=[Math.ceil(c.x/h),Math.ceil(c.y/h)];for(let x of[this.depth,this.found,this.smooth])(x.width!==u||x.height!==f)&&x.setSize(u,f);this.stale&&this.fromSun(e,n,s),this.stale=!1,a.copy(t);let d=t.position.distanceTo(n.center);a.far=d+1.01*n.radius,a.near=Math.max(t.near,d-1.01*n.radius,1e-4*a.far),a.updateProjectionMatrix(),a.updateMatrixWorld();let p={color:o.getClearColor(new Xe),alpha:o.getClearAlpha()};o.setRenderTarget(this.depth),o.render(e,a);let b=new xt().multiplyMatrices(this.sunCamera.projectionMatrix,this.sunCamera.matrixWorldInverse).multiply(a.matrixWorld),m=2*n.radius/this.sun.width,g=new we(u,f);ev(this.find,{depth:this.depth.depthTexture,sun:this.sun.depthTexture,back:a.projectionMatrixInverse,toSun:b,points:g,clip:new we(a.near,a.far),reach:Math.min(Math.max(.9*r,.02*n.radius),.25*n.radius),scale:.5*f/Math.tan(Hn.degToRad(a.fov/2)),lift:1.6*m,sunPoint:1/this.sun.width,bias:.6*m/(2*n.radius)}),o.setRenderTarget(this.found),this.find.render(o),ev(this.mean,{light:this.found.texture,points:g,near:.02}),o.setRenderTarget(this.smooth),this.mean.render(o),o.setRenderTarget(null),o.setClearColor(p.color,p.alpha),l.light.value=this.smooth.texture}fromSun(e,t,n){let{sunCamera:s,renderer:r}=this,o=t.radius;Object.assign(s,{left:-o,right:o,top:o,bottom:-o,near:0,far:2*o}),s.position.copy(t.center).addScaledVector(n.clone().normalize(),o),s.up.set(0,0,1),s.lookAt(t.center),s.updateProjectionMatrix(),s.updateMatrixWorld(),r.setRenderTarget(this.sun),r.render(e,s)}};function ev(i,e){let{uniforms:t}=i.material;for(let[n,s]of Object.entries(e))t[n].value=s}var U2=.004,F2=12e4,O2=.03,k2=[1e6,1e5],B2=300,sm=[3,9],nv=1e-5,z2=.02,Zu=class{constructor(e,t,n,s){this.shape=e;this.software=s;let{info:r}=e;this.dimension=r.dimension,this.size=r.size,this.ids=e.u32("ids"),this.count=this.ids.length,this.rest=e.f32("points"),this.offsets=e.u32("offsets"),this.facesOf=e.u32("facesOf"),this.faceEnds=e.u32("faceEnds"),this.corners=e.u32("corners"),this.twins=e.u32("twins");let o=e.u32("hollowEnds"),a=e.u32("hollowCorners");e.u32("hollow").forEach((f,d)=>{this.hollow.set(f,a.subarray(o[d],o[d+1]))});let l=this.faceEnds.length-1;this.blockOf=new Uint32Array(l);for(let f=0;f<this.count;f++)this.blockOf.fill(f,this.facesOf[f],this.facesOf[f+1]);this.twinOf=new Int32Array(l).fill(-1);for(let f=0;f<this.twins.length;f++)this.twinOf[this.twins[f]]=f>>1;for(let f=0;f<this.count;f++)this.isSurvey(f)&&this.surveys.push(f);this.middles=this.means(),this.positions=this.rest.slice(),this.shades=new Float32Array(this.count).fill(.25),this.drawnAs=new Uint32Array(this.positions.length/3),this.shown=new Uint8Array(this.count).fill(1),this.faceShown=new Uint8Array(l),this.geometry.boundingSphere=new ii,this.edgeGeometry.boundingSphere=this.geometry.boundingSphere;let c=this.dimension===2,h={map:t.texture,side:c?an:Rs,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},u=c?new Yn(h):new As({...h,flatShading:!0});u instanceof As&&tv(u,n),this.mesh=new Lt(this.geometry,u),this.cast=new Lt(this.geometry,new Yn({colorWrite:!1})),this.cast.frustumCulled=!1,this.lines=new er(this.edgeGeometry,new qi({color:0,transparent:!0,opacity:c?.55:.35})),this.mesh.frustumCulled=!1,this.lines.frustumCulled=!1,this.section=new Xu(t.texture),this.side=new Uint8Array(this.count),this.ridges=new qu(this,f=>this.isSurvey(f)),this.object.add(this.mesh,this.lines,this.section.object),this.solid.add(this.cast,this.section.cast)}shape;software;object=new Vt;solid=new Vt;dimension;count;ids;positions;size;surveys=[];visibleFaces=0;rest;offsets;facesOf;faceEnds;corners;twins;hollow=new Map;places=new Map;blockOf;twinOf;middles;geometry=new gt;edgeGeometry=new gt;shades;drawn={count:0,points:new Uint32Array,blocks:new Uint32Array};drawnAs;mesh;cast;lines;section;side;cut=null;plane=new di;shown;faceShown;ridges;triangleFace=new Uint32Array;seen="";gaps=null;gapLimit=0;withEdges=!1;crowded=!1;clear=!1;ink="#000000";dispose(){this.geometry.dispose(),this.edgeGeometry.dispose(),this.mesh.material.dispose(),this.cast.material.dispose(),this.lines.material.dispose(),this.section.dispose()}set glass(e){let t=this.mesh.material;t.transparent=e,t.opacity=e?.14:1,t.depthWrite=!e,t.needsUpdate=!0,this.section.glass=e,this.clear=e,this.tint(this.ink)}tint(e){this.ink=e,this.lines.material.color.set(this.clear?e:"#000000")}fade(e,t=!1){let n=this.size/e,s=t?0:Math.min(1,(n-sm[0])/(sm[1]-sm[0]));this.lines.visible=this.withEdges&&s>0,this.lines.material.opacity=s*(this.dimension===2?.55:.35),this.section.fade(s)}get isSolid(){return this.dimension===3&&!this.clear}get sphere(){return this.geometry.boundingSphere}get cutBlocks(){return this.section.count}isCut(e){return this.cut!==null&&this.side[e]===2}get planes(){return this.cut?[this.plane]:[]}means(){let e=new Float32Array(3*this.count);for(let t=0;t<this.count;t++){let n=this.offsets[t],s=this.offsets[t+1],r=0,o=0,a=0;for(let c=3*n;c<3*s;c+=3)r+=this.rest[c],o+=this.rest[c+1],a+=this.rest[c+2];let l=Math.max(1,s-n);e.set([r/l,o/l,a/l],3*t)}return e}move(e,t){let n=e.f32("shifts"),s=t.exaggeration;this.dimension===2?Yx(this,n,e.f32("turns"),s):jx(this,n,e.i16("turns"),e.info.turnScale/32767,s);let r=e.u32("bent"),o=e.f32("bentShifts"),a=0;for(let u of r)for(let f=3*this.offsets[u];f<3*this.offsets[u+1];f++)this.positions[f]=this.rest[f]+s*o[a++];this.gaps=e.has("gaps")?e.u8("gaps"):null;let{shutDecade:l,steps:c}=e.info,h=u=>Math.ceil((Math.log10(u/Math.max(s,1e-12))-l)*c)+1;this.gapLimit=h(U2),this.gaps&&this.openFaces(this.gapLimit)>F2&&(this.gapLimit=h(O2)),this.bound()}openFaces(e){let t=this.twins.length/2,n=0;for(let s=0;s<t;s++)(this.gaps[s>>1]>>4*(s&1)&15)>=e&&(n+=2);return n}bound(){let e=new $t,t=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0],{positions:s}=this;for(let r=0;r<s.length;r+=3)for(let o=0;o<3;o++){let a=s[r+o];a<t[o]&&(t[o]=a),a>n[o]&&(n[o]=a)}e.min.set(t[0],t[1],t[2]),e.max.set(n[0],n[1],n[2]),e.isEmpty()||e.getBoundingSphere(this.geometry.boundingSphere)}box(){return $x(this)}paint(e,t){let{ids:n,shades:s}=this;for(let r=0;r<this.count;r++){let o=(!t.kinds||t.field==="material")&&this.isSurvey(r);s[r]=o?t.terrain:e?t.place(e[r],n[r]):t.tone(n[r])}}isSurvey(e){return this.dimension===3&&this.facesOf[e+1]-this.facesOf[e]>B2}reveal(e,t){let{shown:n,faceShown:s,twins:r,blockOf:o}=this;if(n.fill(1),e.clip&&this.takeAway(e.clip),this.cut=e.clip?.flat?e.clip:null,e.only&&t){let[a,l]=e.only;for(let c=0;c<this.count;c++)t[c]>=a&&t[c]<=l||(n[c]=0)}for(let a=0;a<s.length;a++)s[a]=n[o[a]];for(let a=0;a<r.length;a+=2){let l=r[a],c=r[a+1];if(!s[l]||!s[c]||this.cut&&(this.side[o[l]]===2||this.side[o[c]]===2))continue;let h=a>>1;(this.gaps?this.gaps[h>>1]>>4*(h&1)&15:15)<this.gapLimit&&(s[l]=0,s[c]=0)}this.index(e.edges),this.send(),this.close(e.edges)}clearOf(e,t){if(this.dimension===2)return t;let{positions:n,corners:s,faceEnds:r}=this,o=z2*this.size,[a,l,c]=e,h=new Float32Array(n.length/3);for(let f=0;f<h.length;f++)h[f]=a*n[3*f]+l*n[3*f+1]+c*n[3*f+2]-t;let u=f=>{for(let d=0;d+1<r.length;d++){let p=r[d];for(;p<r[d+1]&&Math.abs(h[s[p]]-f)<o;)p++;if(p===r[d+1])return!1}return!0};for(let f of[0,1,-1,2,-2,4,-4])if(u(2*f*o))return t+2*f*o;return t}takeAway(e){let{shown:t,side:n,middles:s}=this;if(e.flat){Kx(this,e,nv*this.size,n);for(let l=0;l<this.count;l++)n[l]===0&&(t[l]=0);return}let[r,o,a]=e.normal;for(let l=0;l<this.count;l++){let c=r*s[3*l]+o*s[3*l+1]+a*s[3*l+2]-e.at;e.keep*c<0&&(t[l]=0)}}close(e){let{cut:t,side:n,shown:s}=this;for(let o of[this.mesh,this.lines,this.cast])o.material.clippingPlanes=this.planes;if(!t){this.section.clear();return}this.plane.normal.set(...t.normal).multiplyScalar(t.keep),this.plane.constant=nv*this.size-t.keep*t.at;let r=[];for(let o=0;o<this.count;o++)n[o]===2&&s[o]&&r.push(o);this.section.draw(Qx(this,t,r),this.shades,e)}send(){let{count:e,points:t,blocks:n}=this.drawn,s=this.geometry.getAttribute("position"),r=this.geometry.getAttribute("uv"),o=s.array,a=r.array,{positions:l,shades:c}=this;for(let h=0;h<e;h++){let u=3*t[h];o[3*h]=l[u],o[3*h+1]=l[u+1],o[3*h+2]=l[u+2],a[2*h]=c[n[h]]}ju(s,3*e),ju(r,2*e)}room(e,t,n){let s=this.geometry.getAttribute("position");if(!s||s.count<e){let r=Math.ceil(1.25*e)+64;this.geometry.dispose(),this.edgeGeometry.dispose();let o=new dn(new Float32Array(3*r),3).setUsage(Xl),a=new dn(new Float32Array(2*r),2).setUsage(Xl);this.geometry.setAttribute("position",o),this.geometry.setAttribute("uv",a),this.edgeGeometry.setAttribute("position",o),this.drawn.points=new Uint32Array(r),this.drawn.blocks=new Uint32Array(r)}for(let[r,o]of[[this.geometry,t],[this.edgeGeometry,n]]){let a=r.getIndex();if(a&&a.count>=o)continue;r.dispose();let l=new dn(new Uint32Array(Math.ceil(1.25*o)+64),1);r.setIndex(l.setUsage(Xl))}}index(e){let{faceShown:t,faceEnds:n,corners:s}=this,r=0,o=0,a=0,l=0;for(let v=0;v<t.length;v++)t[v]&&(l=Math.imul(l,31)+v|0,r++,a+=n[v+1]-n[v],o+=this.hollow.has(v)?this.hollow.get(v).length/3:n[v+1]-n[v]-2);this.visibleFaces=r,this.crowded=r>k2[this.software?1:0]&&this.dimension===3;let c=e&&!this.crowded,h=`${l} ${r} ${c}`;if(this.withEdges=c,h===this.seen)return;this.seen=h,this.room(a,3*o,c?2*a:0);let u=this.geometry.getIndex().array,f=this.edgeGeometry.getIndex().array,d=new Uint32Array(o),{drawn:p,drawnAs:b}=this,m=4294967295;b.fill(m),p.count=0;let g=0,x=0,_=this.dimension===2,y=-1,T=0,M=new Int32Array;for(let v=0;v<t.length;v++){if(!t[v])continue;let S=n[v],C=n[v+1];for(let L=S;L<C;L++){let O=s[L];b[O]===m&&(b[O]=p.count,p.points[p.count]=O,p.blocks[p.count++]=this.blockOf[v])}let P=this.hollow.get(v);if(P){d.fill(v,g/3,(g+P.length)/3);for(let L of P)u[g++]=b[L]}else for(let L=S+1;L+1<C;L++)d[g/3]=v,u[g++]=b[s[S]],u[g++]=b[s[L]],u[g++]=b[s[L+1]];if(c){let L=this.blockOf[v];!_&&L!==y&&(y=L,T=n[this.facesOf[L]],M=this.ridges.at(L));for(let O=S;O<C;O++){if(!_){let z=M[O-T],U=z>>1;if(z!==-1&&t[U]&&(U<v||!(z&1)))continue}f[x++]=b[s[O]],f[x++]=b[s[O+1<C?O+1:S]]}}}this.triangleFace=d,ju(this.geometry.getIndex(),g),ju(this.edgeGeometry.getIndex(),x),this.geometry.setDrawRange(0,g),this.edgeGeometry.setDrawRange(0,x)}pick(e){return this.hit(e)?.block??null}hit(e){let t=this.section.pick(e),n=e.intersectObject(this.mesh,!1).find(r=>!this.isAway(r.point));if(t&&(!n||t.distance<n.distance))return{block:t.block,point:e.ray.at(t.distance,new I)};if(!n||n.faceIndex===void 0||n.faceIndex===null)return null;let s=this.blockOf[this.triangleFace[n.faceIndex]];return s===void 0?null:{block:s,point:n.point}}cornersOf(e){let t=[];for(let n=this.offsets[e];n<this.offsets[e+1];n++)t.push(new I().fromArray(this.positions,3*n));return t}placeOf(e){return this.places.size===0&&this.ids.forEach((t,n)=>this.places.set(t,n)),this.places.get(e)??-1}isShown(e){return this.shown[e]===1}isAway(e){return this.cut!==null&&this.plane.distanceToPoint(e)<0}outline(e){let t=[];for(let n=this.facesOf[e];n<this.facesOf[e+1];n++){let s=this.faceEnds[n],r=this.faceEnds[n+1];for(let o=s;o<r;o++)for(let a of[this.corners[o],this.corners[o+1<r?o+1:s]])t.push(...this.positions.subarray(3*a,3*a+3))}return Float32Array.from(t)}};function ju(i,e){i.clearUpdateRanges(),i.addUpdateRange(0,e),i.needsUpdate=!0}function iv(i){return i.reduce((e,[t,n],s)=>{let[r,o]=i[(s+1)%i.length];return e+t*o-r*n},0)}function H2(i,e){let t=i;return e.forEach(([n,s],r)=>{let[o,a]=e[(r+1)%e.length],l=([h,u])=>(o-n)*(u-s)-(a-s)*(h-n),c=[];t.forEach((h,u)=>{let f=t[(u+1)%t.length],[d,p]=[l(h),l(f)];if(d>=0&&c.push(h),d>=0!=p>=0){let b=d/(d-p);c.push([h[0]+b*(f[0]-h[0]),h[1]+b*(f[1]-h[1])])}}),t=c}),t}function sv(i,e,t,n){let{rest:s,corners:r,faceEnds:o}=i,a=C=>Array.from(r.subarray(o[C],o[C+1])),[l,c]=[a(e),a(t)],h=new I().fromArray(s,3*l[1]).sub(new I().fromArray(s,3*l[0])).normalize(),u=n.clone().cross(h),f=C=>{let P=new I().fromArray(s,3*C).sub(new I().fromArray(s,3*l[0]));return[h.dot(P),u.dot(P)]},[d,p]=[l.map(f),c.map(f)],b=H2(d,iv(p)<0?p.reverse():p),m=.5*iv(b);if(b.length<3||!(m>0))return null;let g=C=>Math.abs(d[1][0]*d[C][1]-d[1][1]*d[C][0]),x=2;for(let C=3;C<d.length;C++)g(C)>g(x)&&(x=C);let[[_,y],[T,M]]=[d[1],d[x]],v=_*M-y*T,S=b.flatMap(([C,P])=>[(C*M-P*T)/v,(_*P-y*C)/v]);return{size:m,piece:{base:[l[0],l[1],l[x]],shares:S}}}var V2=15,rv=8,ov="#9a9a9a",av=.002,Ju=class{object;known=new WeakMap;constructor(){this.object=new Lt(new gt,new As({vertexColors:!0,side:an,flatShading:!0})),this.object.frustumCulled=!1,this.object.visible=!1,this.object.renderOrder=2}draw(e,t,n,s){if(this.object.visible=!1,e==="")return[];let r=this.known.get(t);if(!r){let h=t.dimension===3?G2(t):X2(t);r={joints:h,sets:Y2(h,t.dimension)},this.known.set(t,r)}let o=e==="set"?r.sets:j2(r.joints,t.dimension,n,s),a=[],l=[];for(let{note:h,joints:u}of o){let f=u.filter(g=>t.isShown(g.blocks[0])&&t.isShown(g.blocks[1])),d=a.length,p=f.filter(g=>!g.piece).map(g=>g.blocks);for(let g of zu(t,p).points)a.push(g);let b=t.dimension===3?$2:q2;for(let{piece:g}of f)g&&b(t,g,a);let m=new Xe(h.colour).toArray();for(let g=d;g<a.length;g+=3)l.push(...m)}let{geometry:c}=this.object;return c.dispose(),c.setAttribute("position",new Ke(a,3)),c.setAttribute("color",new Ke(l,3)),c.deleteAttribute("normal"),t.dimension===2&&c.setAttribute("normal",new Ke(a.map((h,u)=>u%3===2?1:0),3)),this.object.material.clippingPlanes=t.planes,this.object.visible=a.length>0,o.map(h=>h.note)}};function lv(i,e){let{rest:t,corners:n,faceEnds:s}=i,[r,o,a,l]=[new I,new I,new I,new I];o.fromArray(t,3*n[s[e]]);for(let c=s[e]+1;c+1<s[e+1];c++)a.fromArray(t,3*n[c]).sub(o),l.fromArray(t,3*n[c+1]).sub(o),r.add(a.cross(l));return r}function G2(i){let{twins:e,blockOf:t}=i,n=[],s=new Set(e);for(let r=0;r<e.length;r+=2){let[o,a]=[e[r],e[r+1]],l=lv(i,o),c=.5*l.length();c>0&&n.push({blocks:[t[o],t[a]],axis:l.normalize(),size:c})}return[...n,...W2(i,s)]}function W2(i,e){let{rest:t,corners:n,faceEnds:s,blockOf:r,size:o}=i,a=av*o,l=new Map,c=(b,m,g)=>[...b.toArray().map((x,_)=>Math.round(x/.02)+g[_]),Math.round(m/(4*a))+g[3]].join(" "),h=[];for(let b=0;b+1<s.length;b++){if(e.has(b))continue;let m=lv(i,b);if(!(m.length()>a*a))continue;m.normalize();let g=Array.from(n.subarray(s[b],s[b+1]),v=>Array.from(t.subarray(3*v,3*v+3))),[x,_]=[Math.min,Math.max].map(v=>[0,1,2].map(S=>v(...g.map(C=>C[S])))),y={face:b,normal:m,off:m.dot(new I(...g[0])),low:x,high:_};h.push(y);let T=c(m,y.off,[0,0,0,0]),M=l.get(T);M?M.push(y):l.set(T,[y])}let u=[-1,0,1],f=u.flatMap(b=>u.flatMap(m=>u.flatMap(g=>u.map(x=>[b,m,g,x])))),d=[],p=new I;for(let b of h){p.copy(b.normal).negate();for(let m of f)for(let g of l.get(c(p,-b.off,m))??[]){let[x,_]=[b.face,g.face];if(_<x||r[x]===r[_]||Math.abs(b.off+g.off)>2*a||[0,1,2].some(T=>b.low[T]>g.high[T]+a||g.low[T]>b.high[T]+a))continue;let y=sv(i,x,_,b.normal);y&&y.size>a*o&&d.push({blocks:[r[x],r[_]],axis:b.normal.clone(),...y})}}return d}function X2(i){let{rest:e,corners:t,faceEnds:n,blockOf:s,size:r}=i,o=av*r,a=new Map,l=(h,u,f)=>`${Math.round(Math.atan2(h.direction[1],h.direction[0])/.01)+u} ${Math.round(h.off/(4*o))+f}`,c=[];for(let h=0;h+1<n.length;h++)for(let u=n[h];u<n[h+1];u++){let[f,d]=[t[u],t[u+1<n[h+1]?u+1:n[h]]],[p,b]=[e[3*d]-e[3*f],e[3*d+1]-e[3*f+1]],m=Math.hypot(p,b);if(!(m>o))continue;let g=p>1e-6*m||Math.abs(p)<=1e-6*m&&b>0?1:-1;[p,b]=[g*p/m,g*b/m];let x=S=>p*e[3*S]+b*e[3*S+1],_={block:s[h],corners:[f,d],ends:[x(f),x(d)],direction:[p,b],off:p*e[3*f+1]-b*e[3*f]},[y,T]=[Math.min(..._.ends),Math.max(..._.ends)];for(let S=-1;S<=1;S++)for(let C=-1;C<=1;C++)for(let P of a.get(l(_,S,C))??[]){let L=Math.max(y,Math.min(...P.ends)),O=Math.min(T,Math.max(...P.ends));if(P.block===_.block||O-L<=o||Math.abs(P.off-_.off)>2*o)continue;let z=U=>(U-_.ends[0])/(_.ends[1]-_.ends[0]);c.push({blocks:[_.block,P.block],axis:new I(p,b,0),size:O-L,piece:{base:[f,d],shares:[z(L),z(O)]}})}let M=l(_,0,0),v=a.get(M);v?v.push(_):a.set(M,[_])}return c}function om(i){let{low:e,high:t}=i.shape.info;return Math.min(.025*i.size,Math.hypot(t[0]-e[0],t[1]-e[1])/500)}function q2(i,{base:e,shares:t},n){let{positions:s}=i,r=(b,m)=>(1-t[b])*s[3*e[0]+m]+t[b]*s[3*e[1]+m],[o,a,l,c]=[r(0,0),r(0,1),r(1,0),r(1,1)],h=Math.hypot(l-o,c-a)||1,u=om(i),[f,d]=[-(c-a)/h*u,(l-o)/h*u],p=.35;n.push(o-f,a-d,p,l-f,c-d,p,l+f,c+d,p,o-f,a-d,p,l+f,c+d,p,o+f,a+d,p)}function $2(i,{base:e,shares:t},n){let{positions:s}=i,[r,o,a]=e,l=c=>{for(let h=0;h<3;h++){let u=s[3*r+h];n.push(u+t[2*c]*(s[3*o+h]-u)+t[2*c+1]*(s[3*a+h]-u))}};for(let c=1;2*c+2<t.length;c++)[0,c,c+1].forEach(l)}function Y2(i,e){let t=Math.cos(Hn.degToRad(V2)),n=[];for(let o of[...i].sort((a,l)=>l.size-a.size)){let a,l=t;for(let c of n){let h=Math.abs(c.sum.dot(o.axis))/c.sum.length();h>l&&([a,l]=[c,h])}a||(a={sum:new I,size:0,joints:[]},n.push(a)),a.sum.addScaledVector(o.axis,a.sum.dot(o.axis)<0?-o.size:o.size),a.size+=o.size,a.joints.push(o)}n.sort((o,a)=>a.size-o.size);let s=n.slice(0,rv).map((o,a)=>({note:{text:`set ${a+1}: ${Z2(o.sum,e)}, ${rm(o.size,e)}`,colour:lr(a)},joints:o.joints})),r=n.slice(rv);if(r.length>0){let o=r.reduce((a,l)=>a+l.size,0);s.push({note:{text:`other directions, ${rm(o,e)}`,colour:ov},joints:r.flatMap(a=>a.joints)})}return s}function j2(i,e,t,n){if(!t||!n)return[];let s=Math.round(Math.sqrt(t.pairs.length)),r=new Map;for(let o of i){let[a,l]=o.blocks.map(u=>n[u]),c=t.pairs[a*s+l]??-1,h=r.get(c)??{size:0,joints:[]};h.size+=o.size,h.joints.push(o),r.set(c,h)}return[...r].sort(([o],[a])=>o-a).map(([o,{size:a,joints:l}])=>({note:{text:`${t.interfaces[o]??"no law"}: ${rm(a,e)}`,colour:o<0?ov:lr(o)},joints:l}))}function Z2(i,e){let t=o=>Math.round(Hn.radToDeg(o));if(e===2)return`${(t(Math.atan2(i.y,i.x))+180)%180}\xB0 from x`;let n=i.clone().normalize();n.z<0&&n.negate();let s=t(Math.acos(Math.min(1,n.z))),r=(t(Math.atan2(n.x,n.y))+360)%360;return`${String(s).padStart(2,"0")}\xB0/${s===0?"\u2013":`${String(r).padStart(3,"0")}\xB0`}`}function rm(i,e){return`${Bt(i,3)} ${e===3?"m\xB2":"m"}`}var am={held:{name:"held",colour:"#2f7bd9"},roller:{name:"rollers",colour:"#2aa7a0"},held_along:{name:"held along the face",colour:"#6b7fd7"},moved:{name:"moved",colour:"#e07b1a"},viscous:{name:"viscous",colour:"#8a5cc4"},loaded:{name:"loaded",colour:"#d0342c"}},cv="#c2187a",hv="#1f8fe0",J2=400,Ku=class{object=new Vt;faces;arrows;surface;known=new WeakMap;reach=new $t;constructor(){this.faces=new Lt(new gt,new Yn({vertexColors:!0,side:an,transparent:!0,opacity:.8,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-2}));let e={depthTest:!1,transparent:!0};this.arrows={plane:new Ur(!0,e),space:new Ur(!1,e)};for(let t of Object.values(this.arrows))t.colour=cv;this.surface=new Lt(new gt,new Yn({color:hv,side:an,transparent:!0,opacity:.35,depthWrite:!1}));for(let t of[this.faces,this.surface])t.frustumCulled=!1,t.visible=!1,t.renderOrder=2;this.object.add(this.faces,this.surface,this.arrows.plane.object,this.arrows.space.object)}places(e,t){let n=this.known.get(t);if(n)return n;n=[];let{origin:s}=t.shape.info,r=new I;return e.faces.forEach(({blocks:o,centres:a},l)=>{o.forEach((c,h)=>{let u=t.placeOf(c);if(u<0)return;let f=a[h];r.set(f[0]-s[0],f[1]-s[1],f[2]-s[2]);let d=-1,p=1/0;for(let b=t.facesOf[u];b<t.facesOf[u+1];b++){let m=i3(t,b,r);m<p&&([d,p]=[b,m])}d>=0&&n.push({condition:l,item:h,block:u,face:d})})}),this.known.set(t,n),n}drawFaces(e,t){if(this.faces.visible=!1,!e||t.dimension===2)return[];let n=[],s=[],r=e.faces.map(u=>new Xe(am[u.kind].colour).toArray()),{positions:o,corners:a,faceEnds:l}=t;for(let{condition:u,block:f,face:d}of this.places(e,t)){if(!t.isShown(f))continue;let p=l[d];for(let b=p+1;b+1<l[d+1];b++)for(let m of[a[p],a[b],a[b+1]])n.push(o[3*m],o[3*m+1],o[3*m+2]),s.push(...r[u])}let{geometry:c}=this.faces;c.dispose(),c.setAttribute("position",new Ke(n,3)),c.setAttribute("color",new Ke(s,3)),this.faces.visible=n.length>0,this.faces.material.clippingPlanes=t.planes;let h=[];for(let u of Object.keys(am)){let f=e.faces.filter(g=>g.kind===u),d=f.reduce((g,x)=>g+x.count,0);if(d===0)continue;let p=f.some(g=>g.blocks.length===0)?", too many to draw":"",{name:b,colour:m}=am[u];h.push({text:`${b}: ${d} face${d===1?"":"s"}${p}`,colour:m})}return h}drawLoads(e,t,n,s){let r=t.dimension===2,o=r?this.arrows.plane:this.arrows.space;for(let d of Object.values(this.arrows))d.clear();if(this.reach.makeEmpty(),!e)return[];let a=[...Q2(e,t),...this.tractions(e,t)],l=new Map;for(let{kind:d,unit:p,vector:b}of a){let m=l.get(d),g=b.length();m&&m.count++,(!m||g>m.size)&&l.set(d,{size:g,unit:p,count:m?m.count:1})}let c=[],h=[],u=new I,f=new I;for(let{kind:d,block:p,place:b,vector:m}of a){let{size:g}=l.get(d);!(g>0)||r&&d==="moment"||!t.isShown(p)||(f.copy(m).divideScalar(g),u.copy(b).add(n(p,new I)),u.addScaledVector(f,-s),c.push(...u.toArray()),this.reach.expandByPoint(u),h.push(...f.toArray()))}return c.length>0&&o.draw(new Float32Array(c),new Float32Array(h),1,s),[...l].map(([d,{size:p,unit:b,count:m}])=>({text:`${m===1?d:`${m} ${K2[d]??d}, up to`} ${sn(p,b,3)}`,colour:cv}))}tractions(e,t){if(t.dimension===2)return[];let n=this.places(e,t).filter(o=>e.faces[o.condition].tractions.length>0),s=Math.max(1,Math.ceil(n.length/J2)),{origin:r}=t.shape.info;return n.filter((o,a)=>a%s===0).map(({condition:o,item:a,block:l})=>{let{centres:c,tractions:h}=e.faces[o],u=new I(...c[a]).sub(new I(...r));return{kind:"traction",unit:"Pa",block:l,place:u,vector:new I(...h[a])}})}drawWater(e,t,n){this.surface.visible=!1;let s=e?.standing.find(([l])=>l===n)??e?.standing[0],r=s&&s[1]!==null?e.water[s[1]]:void 0;if(!r)return[];let o=t.dimension===2,a=[];for(let l of r.parts??[r])a.push(...l.grid?e3(l.grid,t):t3(l,t));return this.surface.geometry.dispose(),this.surface.geometry.setAttribute("position",new Ke(a,3)),this.surface.material.opacity=o?.9:.35,this.surface.visible=!0,[{text:`water table ${r.name}`,colour:hv}]}},K2={force:"forces",moment:"moments",pressure:"arrows of pressure",acceleration:"accelerations",traction:"faces loaded"};function Q2(i,e){let{origin:t}=e.shape.info;return i.loads.flatMap(({kind:n,unit:s,block:r,at:o,vector:a})=>{let l=e.placeOf(r),c=new I(...o).sub(new I(...t));return e.dimension===2&&(c.z=0),l<0?[]:[{kind:n,unit:s,block:l,place:c,vector:new I(...a)}]})}function e3([i,e,t],n){let{origin:s}=n.shape.info,r=(a,l)=>[i[a]-s[0],e[l]-s[1],t[l*i.length+a]-s[2]],o=[];for(let a=0;a+1<e.length;a++)for(let l=0;l+1<i.length;l++){let[c,h,u,f]=[r(l,a),r(l+1,a),r(l+1,a+1),r(l,a+1)];o.push(...c,...h,...u,...c,...u,...f)}return o}function t3(i,e){let{low:t,high:n,origin:s}=e.shape.info,r=e.dimension===2,o=(x,_)=>i.along[0]*(x+s[0])+i.along[1]*(_+s[1]),a=r?[t[0]+s[0],n[0]+s[0]]:[0,1,2,3].map(x=>o(x&1?n[0]:t[0],x&2?n[1]:t[1])),[l,c]=[Math.min(...a),Math.max(...a)];r&&i.within&&([l,c]=[Math.max(l,i.within[0][0]),Math.min(c,i.within[1][0])]);let h=n3(i.points,l,c),u=[];if(r){let x=om(e);for(let _=0;_+1<h.length;_++){let[[y,T],[M,v]]=[h[_],h[_+1]].map(([S,C])=>[S-s[0],C-s[1]]);u.push(y,T-x,.45,M,v-x,.45,M,v+x,.45,y,T-x,.45,M,v+x,.45,y,T+x,.45)}return u}let[f,d]=i.along,p=.5*Math.hypot(n[0]-t[0],n[1]-t[1]),b=[s[0]+.5*(t[0]+n[0]),s[1]+.5*(t[1]+n[1])],m=-d*b[0]+f*b[1],g=([x,_],y)=>{let T=m+y*p;return[f*x-d*T-s[0],d*x+f*T-s[1],_-s[2]]};for(let x=0;x+1<h.length;x++){let[_,y]=[h[x],h[x+1]];u.push(...g(_,-1),...g(y,-1),...g(y,1),...g(_,-1),...g(y,1),...g(_,1))}return u}function n3(i,e,t){let n=s=>{let r=i.findIndex(h=>h[0]>s);if(r===0)return i[0][1];if(r<0)return i.at(-1)[1];let[[o,a],[l,c]]=[i[r-1],i[r]];return a+(c-a)*(s-o)/(l-o)};return[[e,n(e)],...i.filter(s=>s[0]>e&&s[0]<t),[t,n(t)]]}function i3(i,e,t){let{rest:n,corners:s,faceEnds:r}=i,[o,a]=[r[e],r[e+1]],l=new I().fromArray(n,3*s[o]),c=new I,[h,u]=[new I,new I];for(let f=o+1;f+1<a;f++)h.fromArray(n,3*s[f]).sub(l),u.fromArray(n,3*s[f+1]).sub(l),c.add(h.cross(u));return Math.abs(c.normalize().dot(h.subVectors(t,l)))}var uv=250,Qu=class{object=Z("div.loading",{role:"status","aria-live":"polite",hidden:!0});all=new Set;timer=0;begin(e,t="bytes",n=null){let s={what:e,got:0,of:n,unit:t,since:performance.now()};return this.all.add(s),this.timer||(this.timer=window.setInterval(()=>this.say(),uv/2)),s}end(e){this.all.delete(e),!(this.all.size>0)&&(clearInterval(this.timer),this.timer=0,this.object.hidden=!0)}async announce(e){let t=this.begin(e);return this.object.hidden=!1,this.write(t),await new Promise(n=>setTimeout(n,30)),t}say(){let e=performance.now(),[t]=[...this.all].filter(n=>e-n.since>uv).sort((n,s)=>(s.of??0)-(n.of??0)||n.since-s.since);t&&(this.object.hidden=!1,this.write(t))}write({what:e,got:t,of:n,unit:s,since:r}){let o=Math.floor((performance.now()-r)/1e3),a=h=>s==="bytes"?(h/1e6).toFixed(h<1e7?1:0):String(h),l=n===null?o>1?`, ${o} s`:"":`: ${a(t)} of ${a(n)} ${s==="bytes"?"MB":"frames"}`,c=n===null?null:Z("progress",{max:n,value:t});this.object.replaceChildren(Z("span",{},`${e}${l}`),...c?[c]:[])}},s3={summary:"the run",shape:"the shapes of the blocks",frame:"the places of the blocks",contacts:"the contacts",cracks:"the cracks",bolts:"the bolts",stress:"the stresses",conditions:"the conditions",names:"the names",table:"the histories"};function fv(i){let[e,t=""]=i.split(/[/?](.*)/s),n=new URLSearchParams(i.split("?")[1]??"").get("name");return n?`Reading ${n}`:e==="block"?`Reading block ${t.split("/")[1]??""}`:`Reading ${s3[e]??i}`}var r3={f32:Float32Array,f64:Float64Array,u32:Uint32Array,i16:Int16Array,u8:Uint8Array},ec=class{info;bytes;arrays=new Map;constructor(e){let t=new DataView(e).getUint32(0,!0),n=JSON.parse(new TextDecoder().decode(new Uint8Array(e,4,t)));this.info=n.info,this.bytes=e.byteLength;let s=Math.ceil((4+t)/8)*8;for(let r of n.arrays)this.arrays.set(r.name,new r3[r.type](e,s+r.at,r.length))}has(e){return this.arrays.has(e)}f32(e){return this.get(e)}f64(e){return this.get(e)}u32(e){return this.get(e)}i16(e){return this.get(e)}u8(e){return this.get(e)}get(e){let t=this.arrays.get(e);if(!t)throw new Error(`the answer has no array ${e}`);return t}};var Mn=class extends Error{constructor(t,n){super(t);this.what=t;this.hint=n}what;hint},ef=class{constructor(e,t){this.run=e;this.loading=t}run;loading;json(e){return this.told(e,async t=>await t.json())}packet(e){return this.told(e,async(t,n)=>new ec(await o3(t,n)))}async told(e,t){let n=this.loading.begin(fv(e));try{return await t(await this.ask(e),n)}finally{this.loading.end(n)}}file(e){return`api/${this.run}/file/${e}`}async ask(e){let t;try{t=await fetch(`api/${this.run}/${e}`)}catch{throw new Mn("The viewer does not answer any more.","Start it again: riprap view RUN")}if(t.ok)return t;let n=await t.json().catch(()=>({}));throw new Mn(n.what??`${e}: ${t.status}`,n.hint??"Reload the page.")}};async function o3(i,e){let t=Number(i.headers.get("content-length"));if(!i.body||!(t>1e6))return i.arrayBuffer();e.of=t;let n=new Uint8Array(t),s=i.body.getReader();for(;;){let{done:r,value:o}=await s.read();if(r)break;n.set(o,e.got),e.got+=o.length}if(e.got!==t)throw new Mn("The answer of the viewer was cut off.","Reload the page.");return n.buffer}var tf=class{constructor(e){this.answers=e}answers;async json(e){return JSON.parse(new TextDecoder().decode(await this.bytes(e)))}async packet(e){return new ec(await this.bytes(e))}file(){}async bytes(e){let t=this.answers.get(e);if(typeof t=="object"&&(t=this.answers.get(t.as)),typeof t!="string")throw new Mn("The report does not hold this.","Look at the run itself: riprap view RUN");let n=Uint8Array.from(atob(t),r=>r.charCodeAt(0)),s=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(s).arrayBuffer()}};function lm(i,e){let t=i.blocks.findLast(n=>n.first<=e);return!t||e>=t.first+(t.count??1)?"":t.from===void 0?t.name:`${t.name}.${t.from+e-t.first}`}async function dv(i,e,t){let n=await i.motion(e);return(await i.shape(n.info.shape,e)).u32("ids").indexOf(t)}async function pv(i,e,t){let n=await dv(i,e,t);if(n<0)throw new Mn(`there is no block ${t} in this frame`,"It was split, cut or removed.");let{held:s,names:r,fields:o}=i.summary,a=await Promise.all((r??[]).map(async h=>{let u=o.find(d=>d.name===h)?.components??1;if(s.vectors.includes(h)){let d=await i.vectors(e,h);return{name:h,unit:d.info.unit,values:[...d.f32("values").subarray(3*n,3*n+u)]}}let f=await i.field(e,h).catch(()=>null);return{name:h,unit:f?.info.unit??"",values:f?[f.f32("values")[n]]:[]}})),{names:l}=i,c=l.groups.filter(h=>h.blocks.some(([u,f])=>u<=t&&t<=f)).map(h=>h.name);return{block:t,name:lm(l,t),groups:c,frame:e,columns:a.filter(h=>h.values.length>0)}}async function mv(i,e,t,n){let s=[],r="";for(let o=0;o<i.frames;o++){let a=await dv(i,o,e),l=a<0?null:await i.field(o,t).catch(()=>null);r=l?.info.unit??r;let c=l?.f32("values")[a];s.push(c!==void 0&&Number.isFinite(c)?c:null)}n(s,r)}var a3=4e8;function cm(i){let e=sn(i.time,"s");if(!i.still)return e;let t=[i.phase,`step ${i.step}`].filter(Boolean);return(i.time===0?t:[e,...t]).join(", ")}var nf=class i{constructor(e,t){this.source=e;this.summary=t}source;summary;memory=new Map;held=0;ranges=new Map;conditions=null;names={blocks:[],groups:[]};static async open(e){return new i(e,await e.json("summary"))}get frames(){return this.summary.times?.length??0}async refresh(){let e=await this.source.json("summary");if(e.problem&&!this.summary.problem)throw new Mn(e.problem.what,e.problem.hint);let t=this.summary.manifest,n=!e.problem&&(e.manifest.started!==t?.started||e.manifest.input_hash!==t.input_hash);return n&&(this.memory.clear(),this.held=0),e.times?.length!==this.summary.times?.length&&this.ranges.clear(),this.summary=e,n}async readModel(){[this.conditions,this.names]=await Promise.all([this.source.json("conditions").catch(()=>null),this.source.json("names").catch(()=>this.names)])}get hasStress(){let{held:e,fields:t}=this.summary;return e?e.stress:(t??[]).some(n=>n.name==="stress_shear")}called(e){return lm(this.names,e)||`block ${e}`}motion(e){return this.packet(`frame/${e}`)}shape(e,t){return this.packet(`shape/${t}`,`shape ${e}`)}field(e,t){return this.packet(`field/${e}?name=${encodeURIComponent(t)}`)}vectors(e,t){return this.packet(`vectors/${e}?name=${encodeURIComponent(t)}`)}contacts(e){return this.packet(`contacts/${e}`)}cracks(e){return this.packet(`cracks/${e}`)}bolts(e){return this.packet(`bolts/${e}`)}stress(e){return this.packet(`stress/${e}`)}block(e,t){return this.summary.held?pv(this,e,t):this.source.json(`block/${e}/${t}`)}async history(e,t,n){let s=[];if(this.summary.held)return mv(this,e,t,n);let r=24;for(let o=0;o<this.frames;o+=r){let a=await this.source.json(`history/${e}?name=${encodeURIComponent(t)}&from=${o}&count=${r}`);if(s.push(...a.values.map(l=>typeof l=="number"?l:null)),!n(s,a.unit))return}}hasField(e){let t=e.replace(/\.(x|y|z|magnitude)$/,"");return(this.summary.fields??[]).some(n=>n.name===t)}range(e){let t=this.ranges.get(e);if(t!==void 0)return t;let n=this.readRange(e);return this.ranges.set(e,n),n.catch(()=>this.ranges.delete(e)),n}async readRange(e){let t={range:null,most:null},n=24,s=this.summary.held!==void 0;for(let r=0;r<(s?1:this.frames);r+=n){let o=s?"":`&from=${r}&count=${n}`,a=await this.source.json(`range?name=${s?e:encodeURIComponent(e)}${o}`);t.range=sf(t.range,a.range),t.most=sf(t.most,a.most??a.range)}return t}async table(e){let t=await this.source.packet(`table/${e}`),n=t.info.columns,s=n.map((l,c)=>c).filter(l=>!["time","step"].includes(n[l].name)),r=l=>{let c=n.findIndex(h=>h.name===l);return c<0?new Float64Array:t.f64(String(c))},o=r("time"),a=o.length>1&&o.every(l=>l===o[0]);return{names:s.map(l=>n[l].name),units:s.map(l=>n[l].unit),columns:s.map(l=>t.f64(String(l))),x:a?r("step"):o,bySteps:a}}moments(){let e=0,{steps:t,phases:n}=this.summary;return(this.summary.times??[]).map((s,r,o)=>{e=r>0&&o[r-1]===s?e+1:0;let a=e>0||o[r+1]===s;return{time:s,nth:e,step:t[r]??0,phase:n[r]??"",still:a}})}saidAt(e){let t=this.moments()[e];return t?cm(t):""}frameAt(e){let t=this.moments(),n=1e-9*Math.abs(e.time),s=0,r=t.length;for(;s<r;){let o=s+r>>1,{time:a,nth:l}=t[o];(Math.abs(a-e.time)<=n?l<=e.nth:a<e.time)?s=o+1:r=o}return Math.max(0,s-1)}packet(e,t=e){let n=this.memory.get(t);if(n)return this.memory.delete(t),this.memory.set(t,n),n.answer;let s=this.source.packet(e),r={answer:s,bytes:0};return this.memory.set(t,r),s.then(o=>{r.bytes=o.bytes,this.held+=o.bytes;for(let[a,l]of this.memory){if(this.held<a3)break;l!==r&&l.bytes>0&&(this.memory.delete(a),this.held-=l.bytes)}},()=>this.memory.delete(t)),s}};function sf(i,e){return i&&e?[Math.min(i[0],e[0]),Math.max(i[1],e[1])]:i??e}function ur(i){return i instanceof Mn?{what:i.what,hint:i.hint}:{what:i instanceof Error?i.message:String(i),hint:"Reload the page."}}async function gv(i,e,t,n){let{field:s,vectors:r,rangeMode:o}=t,{held:a}=i.summary,l=r==="contact force"||r==="seepage flow",c=(t.contacts||t.cracks||t.chains||l)&&(!a||a.contacts),h=r!==""&&!l&&i.hasField(r)&&(!a||a.vectors.includes(r)),u=Promise.resolve(null),f=s!==""&&i.hasField(s),d=t.cracks&&i.summary.cracks,p=t.bolts&&i.summary.bolts===!0,b=t.stress&&i.hasStress,m=t.supports&&i.hasField("held"),g=t.joints==="interface"&&i.hasField("material"),[x,_,y,T,M,v,S,C,P,L]=await Promise.all([i.motion(e),f?i.field(e,s):u,f&&n&&(o==="run"||o==="most")&&!cr.has(s)?l3(n,s,o):u,h?i.vectors(e,r):u,c?i.contacts(e):u,d?i.cracks(e).catch(()=>null):u,p?i.bolts(e).catch(()=>null):u,b?i.stress(e):u,m?i.field(e,"held").catch(()=>null):u,g?i.field(e,"material").catch(()=>null):u]);return{k:e,motion:x,field:_,range:y,vectors:T,contacts:M,cracks:v,bolts:S,stress:C,supports:P,materials:L}}async function l3(i,e,t){return(await Promise.all(i.map(s=>s.range(e)))).map(s=>t==="most"?s.most:s.range).reduce(sf,null)}function rf(i,e){let{clipAxis:t,clipAt:n,clipDip:s,clipDirection:r,clipFlip:o,clipFlat:a}=e,l=i.dimension===2;if(t===""||t==="z"&&l)return null;let c=[0,0,0];t!=="free"?c["xyz".indexOf(t)]=1:c=l?Jx(s):Zx(s,r);let{low:h,high:u}=i.shape.info,f=[0,0];c.forEach((m,g)=>{f[0]+=Math.min(m*h[g],m*u[g]),f[1]+=Math.max(m*h[g],m*u[g])});let d=f[0]+n*(f[1]-f[0]),p=a?i.clearOf(c,d):d;return{normal:c,at:p,keep:(t==="z"||t==="free")===o?1:-1,flat:a}}function bv(i,e){let t=rf(i,e);if(!t)return null;let n=-t.keep;return{normal:t.normal.map(s=>n*s),at:n*xv(i,t)}}function xv(i,{normal:e,at:t}){let{origin:n}=i.shape.info;return t+e.reduce((s,r,o)=>s+r*n[o],0)}function vv(i,e){let t=rf(i,e);if(!t)return"";let{clipAxis:n,clipDip:s,clipDirection:r}=e;if(n!=="free")return`cut at ${n} = ${sn(xv(i,t),"m",3)}`;let o=i.dimension===2,a=l=>String(Math.round(l)).padStart(o?1:2,"0");return o?`cut at ${a(s)}\xB0 from x`:`cut ${a(s)}\xB0/${a(r).padStart(3,"0")}\xB0 (dip/direction)`}var yv={type:"change"},um={type:"start"},wv={type:"end"},of=new Js,_v=new di,c3=Math.cos(70*Hn.DEG2RAD),In=new I,Mi=2*Math.PI,Rt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},hm=1e-6,af=class extends Fl{constructor(e,t=null){super(e,t),this.state=Rt.NONE,this.target=new I,this.cursor=new I,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:$i.ROTATE,MIDDLE:$i.DOLLY,RIGHT:$i.PAN},this.touches={ONE:as.ROTATE,TWO:as.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new I,this._lastQuaternion=new mi,this._lastTargetPosition=new I,this._quat=new mi().setFromUnitVectors(e.up,new I(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ra,this._sphericalDelta=new ra,this._scale=1,this._panOffset=new I,this._rotateStart=new we,this._rotateEnd=new we,this._rotateDelta=new we,this._panStart=new we,this._panEnd=new we,this._panDelta=new we,this._dollyStart=new we,this._dollyEnd=new we,this._dollyDelta=new we,this._dollyDirection=new I,this._mouse=new we,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=u3.bind(this),this._onPointerDown=h3.bind(this),this._onPointerUp=f3.bind(this),this._onContextMenu=v3.bind(this),this._onMouseWheel=m3.bind(this),this._onKeyDown=g3.bind(this),this._onTouchStart=b3.bind(this),this._onTouchMove=x3.bind(this),this._onMouseDown=d3.bind(this),this._onMouseMove=p3.bind(this),this._interceptControlDown=y3.bind(this),this._interceptControlUp=_3.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Rt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(yv),this.update(),this.state=Rt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;In.copy(t).sub(this.target),In.applyQuaternion(this._quat),this._spherical.setFromVector3(In),this.autoRotate&&this.state===Rt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Mi:n>Math.PI&&(n-=Mi),s<-Math.PI?s+=Mi:s>Math.PI&&(s-=Mi),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(In.setFromSpherical(this._spherical),In.applyQuaternion(this._quatInverse),t.copy(this.target).add(In),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=In.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new I(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new I(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=In.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(of.origin.copy(this.object.position),of.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(of.direction))<c3?this.object.lookAt(this.target):(_v.setFromNormalAndCoplanarPoint(this.object.up,this.target),of.intersectPlane(_v,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>hm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>hm||this._lastTargetPosition.distanceToSquared(this.target)>hm?(this.dispatchEvent(yv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Mi/60*this.autoRotateSpeed*e:Mi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){In.setFromMatrixColumn(t,0),In.multiplyScalar(-e),this._panOffset.add(In)}_panUp(e,t){this.screenSpacePanning===!0?In.setFromMatrixColumn(t,1):(In.setFromMatrixColumn(t,0),In.crossVectors(this.object.up,In)),In.multiplyScalar(e),this._panOffset.add(In)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;In.copy(s).sub(this.target);let r=In.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Mi*this._rotateDelta.x/t.clientHeight),this._rotateUp(Mi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Mi*this._rotateDelta.x/t.clientHeight),this._rotateUp(Mi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new we,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function h3(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function u3(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function f3(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(wv),this.state=Rt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function d3(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case $i.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Rt.DOLLY;break;case $i.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Rt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Rt.ROTATE}break;case $i.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Rt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Rt.PAN}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(um)}function p3(i){switch(this.state){case Rt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Rt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Rt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function m3(i){this.enabled===!1||this.enableZoom===!1||this.state!==Rt.NONE||(i.preventDefault(),this.dispatchEvent(um),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(wv))}function g3(i){this.enabled!==!1&&this._handleKeyDown(i)}function b3(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case as.ROTATE:if(this.enableRotate===!1){this.state=Rt.NONE;break}this._handleTouchStartRotate(i),this.state=Rt.TOUCH_ROTATE;break;case as.PAN:if(this.enablePan===!1){this.state=Rt.NONE;break}this._handleTouchStartPan(i),this.state=Rt.TOUCH_PAN;break;default:this.state=Rt.NONE}break;case 2:switch(this.touches.TWO){case as.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Rt.TOUCH_DOLLY_PAN;break;case as.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Rt.TOUCH_DOLLY_ROTATE;break;default:this.state=Rt.NONE}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(um)}function x3(i){switch(this._trackPointer(i),this.state){case Rt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Rt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Rt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Rt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Rt.NONE}}function v3(i){this.enabled!==!1&&i.preventDefault()}function y3(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function _3(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var w3=[15e5,15e4],S3=2e4,M3=220,lf=class{constructor(e,t){this.host=e;this.dimension=t;if(!document.createElement("canvas").getContext("webgl2"))throw new Mn("This browser does not support WebGL 2.","Switch on its hardware acceleration or try another browser. Without it, riprap shot RUN draws blocks in space and riprap plot RUN blocks those of the plane.");let n=E3();this.software=n,this.renderer=new Lu({antialias:!n,preserveDrawingBuffer:!0}),this.renderer.localClippingEnabled=!0,this.renderer.setPixelRatio(n?1:Math.min(window.devicePixelRatio,2)),this.canvas=this.renderer.domElement,this.canvas.tabIndex=0,this.canvas.setAttribute("aria-label","the blocks"),e.append(this.canvas),this.shading=new Yu(this.renderer,n),this.scene.add(this.sky,this.light,this.axes),this.camera=this.makeCamera(),this.controls=this.makeControls(),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}host;dimension;canvas;scene=new ll;renderer;camera;controls;onMove=null;onDrawn=null;onDraw=null;standing=0;moving=!1;shadowed=null;shading;software;light=new Ll(16777215,1.5);sky=new Pl(16777215,13684944,1.35);due=!1;up="z";following=!1;axes=new Vt;box=new $t(new I(-1,-1,-1),new I(1,1,1));set background(e){this.scene.background=new Xe(e),this.redraw()}setDimension(e,t){e===this.dimension&&t===this.up||(this.dimension=e,this.up=t,this.controls.dispose(),this.camera=this.makeCamera(),this.controls=this.makeControls(),this.resize())}makeCamera(){if(this.dimension===2)return new Ui(-1,1,1,-1,.1,1e3);let e=new gn(32,1,.01,1e3);return e.up.set(0,this.up==="y"?1:0,this.up==="y"?0:1),e}makeControls(){let e=new af(this.camera,this.canvas);return e.zoomToCursor=!0,e.screenSpacePanning=!0,this.dimension===2&&(e.enableRotate=!1,e.mouseButtons={LEFT:$i.PAN,MIDDLE:$i.DOLLY,RIGHT:$i.PAN},e.touches={ONE:as.PAN,TWO:as.DOLLY_PAN}),e.addEventListener("change",()=>{this.moves(),this.redraw(),this.following||this.onMove?.(this.standpoint())}),e}moves(){let{shadowed:e}=this;!this.software||this.following||!e||e.visibleFaces<=S3||(this.moving=!0,clearTimeout(this.standing),this.standing=window.setTimeout(()=>{this.moving=!1,this.redraw()},M3))}stand(){clearTimeout(this.standing),this.moving=!1}standpoint(){return{position:this.camera.position.clone(),target:this.controls.target.clone(),zoom:this.camera.zoom}}follow(e){this.following=!0,this.camera.position.copy(e.position),this.controls.target.copy(e.target),this.camera.zoom=e.zoom,this.camera.updateProjectionMatrix(),this.controls.update(),this.following=!1,this.redraw()}look(e,t="default"){e.isEmpty()||(this.box=e.clone());let n=this.box.getCenter(new I),s=this.box.getSize(new I);if(this.controls.target.copy(n),this.camera.zoom=1,this.camera instanceof Ui)this.camera.position.set(n.x,n.y,n.z+100),this.frameOrthographic(s);else{let r={default:[-.55,.62,1],x:[1,0,0],y:[0,1,.001],z:[0,0,1]},o={default:[-.55,-1,.62],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},a=this.up==="y"?r:o,l=Math.max(1e-9,.5*s.length()),c=Hn.degToRad(this.camera.fov/2),h=Math.min(c,Math.atan(Math.tan(c)*this.camera.aspect)),u=new I(...a[t]).normalize().multiplyScalar(1.02*l/Math.sin(h));this.camera.position.copy(n).add(u),this.camera.near=l/200,this.camera.far=l*200}this.camera.updateProjectionMatrix(),this.controls.update(),this.stand(),this.redraw()}frameOrthographic(e){let t=this.camera,{clientWidth:n,clientHeight:s}=this.host,r=n>0&&s>0?n/s:1,o=.53*Math.max(e.y,e.x/r,1e-9);t.left=-o*r,t.right=o*r,t.top=o,t.bottom=-o}resize(){let{clientWidth:e,clientHeight:t}=this.host;e===0||t===0||(this.renderer.setSize(e,t,!1),this.camera instanceof gn?this.camera.aspect=e/t:this.frameOrthographic(this.box.getSize(new I)),this.camera.updateProjectionMatrix(),this.draw())}redraw(){this.due||(this.due=!0,requestAnimationFrame(()=>{this.due&&this.draw()}))}draw(){this.due=!1;let e=this.up==="y"?new I(-1,1.5,.5):new I(-1,-.5,1.5);this.light.position.copy(e),this.sky.position.set(0,this.up==="y"?1:0,this.up==="y"?0:1),this.onDraw?.(this.metresPerPixel(),this.moving);let{shadowed:t,camera:n}=this;t?.isSolid&&!this.moving&&!this.tooMany(t)&&n instanceof gn?this.shading.draw(t.solid,n,t.sphere,e,t.size):this.shading.clear(),this.renderer.render(this.scene,this.camera),this.onDrawn?.()}tooMany(e){return e.visibleFaces>w3[this.software?1:0]}ray(e,t){let n=this.canvas.getBoundingClientRect(),s=new we(2*(e-n.left)/n.width-1,1-2*(t-n.top)/n.height),r=new Nl;return r.setFromCamera(s,this.camera),r}onScreen(e){let t=this.canvas.getBoundingClientRect(),n=e.clone().project(this.camera);return[t.left+(.5+.5*n.x)*t.width,t.top+(.5-.5*n.y)*t.height]}triad(){let e=this.camera.quaternion.clone().invert();return[0,1,2].map(t=>{let n=new I().setComponent(t,1).applyQuaternion(e);return[n.x,n.y]})}metresPerPixel(){let e=Math.max(1,this.host.clientHeight);return this.camera instanceof Ui?(this.camera.top-this.camera.bottom)/this.camera.zoom/e:2*this.camera.position.distanceTo(this.controls.target)*Math.tan(Hn.degToRad(this.camera.fov/2))/e}};function E3(){let i=document.createElement("canvas").getContext("webgl2");if(!i)return!1;let e=i.getExtension("WEBGL_debug_renderer_info"),t=String(i.getParameter(e?e.UNMASKED_RENDERER_WEBGL:i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(t)}var T3=.5,cf=class{object=new Vt;whole=new hf;fine=new hf;constructor(){this.object.add(this.whole.object,this.fine.object)}draw(e,t,n,s,r){if(this.whole.clear(),this.fine.clear(),!e)return null;let{longest:o,tetSize:a}=e.info,l=0;if(o!==null){let c=.9*t.size*s.vectorSize,h={longest:o,arms:e.f32("arms"),tension:e.u8("tension")};if(l=this.whole.draw(h,...A3(t,n,s,new Set(e.u32("tetBlock"))),c,Math.min(c/14,r)),a!==null){let u={longest:o,arms:e.f32("tetArms"),tension:e.u8("tetTension")},f=T3*a*s.vectorSize;l+=this.fine.draw(u,...R3(t,n,s,e),f,Math.min(f/10,r))}}return{...e.info,beyond:l}}},hf=class extends pa{draw({longest:e,arms:t,tension:n},s,r,o,a){this.clear();let l=Math.max(1,Math.ceil(s.length/Qp)),c=s.filter((m,g)=>g%l===0),h=new Qs(new Cr(1,1,1),this.material,3*c.length),u=new nn,f=new I,d=new Xe,p=0;for(let m of c)for(let g=0;g<3;g++){let x=f.fromArray(t,9*m+3*g).length();x>.01*e&&(u.position.fromArray(r,3*m),u.quaternion.setFromUnitVectors(ma,f.divideScalar(x)),u.scale.set(o*Math.min(1,x/e),a,a),u.updateMatrix(),h.setMatrixAt(p,u.matrix),h.setColorAt(p++,d.set(n[3*m+g]?Ql:Kl)))}h.count=p,h.frustumCulled=!1,h.renderOrder=4,this.mesh=h,this.object.add(h);let b=m=>[0,1,2].some(g=>f.fromArray(t,9*m+3*g).length()>1.001*e);return s.filter(b).length}};function A3(i,e,t,n){let s=i.dimension===2,r=new Float32Array(3*i.count),o=[],a=new I;for(let l=0;l<i.count;l++){e(l,a).multiplyScalar(t.exaggeration);for(let h=0;h<3;h++)r[3*l+h]=i.middles[3*l+h]+a.getComponent(h);let c=s||i.cutBlocks===0?!i.isAway(a.fromArray(r,3*l)):i.isCut(l);s&&(r[3*l+2]=.5),i.isShown(l)&&c&&Number.isFinite(a.x)&&!n.has(l)&&o.push(l)}return[o,r]}function R3(i,e,t,n){let[s,r]=[n.f32("tetCorners"),n.u32("tetBlock")],o=new Float32Array(3*r.length),a=[],[l,c,h]=[new I,new I,new I];return r.forEach((u,f)=>{if(u>=i.count||!i.isShown(u))return;e(u,h).multiplyScalar(t.exaggeration-1),c.set(0,0,0);let[d,p]=[0,0];for(;p<4;p++)l.fromArray(s,12*f+3*p).add(h),i.isAway(l)&&d++,c.addScaledVector(l,.25);c.toArray(o,3*f),(i.cutBlocks===0?d===0:d>0&&d<p)&&Number.isFinite(c.x)&&a.push(f)}),[a,o]}var fm=80;function dm(i){let e=JSON.parse(i).notes??[],t=n=>new Mn(`views.json: ${n}.`,"Save the file again from the viewer.");if(!Array.isArray(e))throw t("`notes` is no list");return e.map((n,s)=>{let{text:r,at:o,block:a}=n,l=Array.isArray(o)&&o.length===3&&o.every(c=>Number.isFinite(c));if(typeof r!="string"||!l)throw t(`note ${s+1} needs a text and a place \`at\``);return{text:r.slice(0,fm),at:o,block:typeof a=="number"?a:null}})}function Sv(i,e,t,n){let s=new I().fromArray(i.middles,3*e),r=t.f32("shifts"),o=new mi,a=new I;if(i.dimension===2)a.set(r[2*e],r[2*e+1],0),o.setFromAxisAngle(new I(0,0,1),t.f32("turns")[e]);else{a.fromArray(r,3*e);let h=t.i16("turns"),[u,f,d]=[0,1,2].map(p=>h[3*e+p]*t.info.turnScale/32767);o.set(u,f,d,Math.sqrt(Math.max(0,1-u*u-f*f-d*d)))}let l=new Qe().setFromMatrix4(new xt().makeRotationFromQuaternion(o)),c=new Qe;return l.elements.forEach((h,u)=>c.elements[u]=n*h+(u%4===0?1-n:0)),{turn:c,middle:s,shift:a.multiplyScalar(n)}}function C3(i,e,t,n){let s=new I(...i.at).sub(new I(...e.shape.info.origin));if(i.block===null)return s;let r=e.placeOf(i.block);if(r<0||!e.isShown(r))return null;let{turn:o,middle:a,shift:l}=Sv(e,r,t,n);return s.sub(a).applyMatrix3(o).add(a).add(l)}function Mv(i,e,t,n,s){return i.flatMap(r=>{let o=C3(r,e,t,n);if(!o||e.isAway(o))return[];let a=o.project(s);return Math.abs(a.x)<1&&Math.abs(a.y)<1&&a.z<1?[{text:r.text,x:.5+.5*a.x,y:.5-.5*a.y}]:[]})}function Ev(i,e,t,n,s,r){let o=e.clone(),a=t===null?-1:n.placeOf(t);if(a>=0){let{turn:l,middle:c,shift:h}=Sv(n,a,s,r);o.sub(c).sub(h).applyMatrix3(l.invert()).add(c)}return o.add(new I(...n.shape.info.origin)),n.dimension===2&&(o.z=0),{text:i,at:o.toArray(),block:a>=0?t:null}}function Tv(i){return i.map(({text:e,x:t,y:n})=>{let s=Z("div.note-label",{},Z("i"),Z("span",{},e));return s.style.left=`${(100*t).toFixed(2)}%`,s.style.top=`${(100*n).toFixed(2)}%`,s})}function Av(i,e,[t,n,s,r],o,[a,l]){i.font=`${12*o}px system-ui, sans-serif`,i.textBaseline="middle";for(let c of e){let[h,u]=[t+c.x*s,n+c.y*r],[f,d]=[h+14*o,u-18*o],p=i.measureText(c.text).width;i.strokeStyle=a,i.lineWidth=o,i.beginPath(),i.moveTo(h,u),i.lineTo(f,d),i.stroke(),i.fillStyle=l,i.fillRect(f-4*o,d-9*o,p+8*o,18*o),i.strokeRect(f-4*o,d-9*o,p+8*o,18*o),i.fillStyle=a,i.fillText(c.text,f,d),i.beginPath(),i.arc(h,u,2.5*o,0,2*Math.PI),i.fill()}}Ie.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new we},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};bi.line={uniforms:ql.merge([Ie.common,Ie.fog,Ie.line]),vertexShader:`
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
		`};var ga=class extends _i{constructor(e){super({type:"LineMaterial",uniforms:ql.clone(bi.line.uniforms),vertexShader:bi.line.vertexShader,fragmentShader:bi.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Rv=new $t,uf=new I,ba=class extends Dl{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Ke(e,3)),this.setAttribute("uv",new Ke(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new Dr(t,6,1);return this.setAttribute("instanceStart",new rs(n,3,0)),this.setAttribute("instanceEnd",new rs(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new Dr(t,6,1);return this.setAttribute("instanceColorStart",new rs(n,3,0)),this.setAttribute("instanceColorEnd",new rs(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new Al(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new $t);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Rv.setFromBufferAttribute(t),this.boundingBox.union(Rv))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ii),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)uf.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(uf)),uf.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(uf));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var pm=new It,Cv=new I,Pv=new I,jn=new It,Zn=new It,Is=new It,mm=new I,gm=new xt,Jn=new Ul,Iv=new I,ff=new $t,df=new ii,Ls=new It,Ds,oo;function Lv(i,e,t){return Ls.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),Ls.multiplyScalar(1/Ls.w),Ls.x=oo/t.width,Ls.y=oo/t.height,Ls.applyMatrix4(i.projectionMatrixInverse),Ls.multiplyScalar(1/Ls.w),Math.abs(Math.max(Ls.x,Ls.y))}function P3(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Jn.start.fromBufferAttribute(s,a),Jn.end.fromBufferAttribute(r,a),Jn.applyMatrix4(t);let c=new I,h=new I;Ds.distanceSqToSegment(Jn.start,Jn.end,h,c),h.distanceTo(c)<oo*.5&&e.push({point:h,pointOnLine:c,distance:Ds.origin.distanceTo(h),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function I3(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),u=-e.near;Ds.at(1,Is),Is.w=1,Is.applyMatrix4(e.matrixWorldInverse),Is.applyMatrix4(n),Is.multiplyScalar(1/Is.w),Is.x*=r.x/2,Is.y*=r.y/2,Is.z=0,mm.copy(Is),gm.multiplyMatrices(e.matrixWorldInverse,o);for(let f=0,d=h;f<d;f++){if(jn.fromBufferAttribute(l,f),Zn.fromBufferAttribute(c,f),jn.w=1,Zn.w=1,jn.applyMatrix4(gm),Zn.applyMatrix4(gm),jn.z>u&&Zn.z>u)continue;if(jn.z>u){let _=jn.z-Zn.z,y=(jn.z-u)/_;jn.lerp(Zn,y)}else if(Zn.z>u){let _=Zn.z-jn.z,y=(Zn.z-u)/_;Zn.lerp(jn,y)}jn.applyMatrix4(n),Zn.applyMatrix4(n),jn.multiplyScalar(1/jn.w),Zn.multiplyScalar(1/Zn.w),jn.x*=r.x/2,jn.y*=r.y/2,Zn.x*=r.x/2,Zn.y*=r.y/2,Jn.start.copy(jn),Jn.start.z=0,Jn.end.copy(Zn),Jn.end.z=0;let b=Jn.closestPointToPointParameter(mm,!0);Jn.at(b,Iv);let m=Hn.lerp(jn.z,Zn.z,b),g=m>=-1&&m<=1,x=mm.distanceTo(Iv)<oo*.5;if(g&&x){Jn.start.fromBufferAttribute(l,f),Jn.end.fromBufferAttribute(c,f),Jn.start.applyMatrix4(o),Jn.end.applyMatrix4(o);let _=new I,y=new I;Ds.distanceSqToSegment(Jn.start,Jn.end,y,_),t.push({point:y,pointOnLine:_,distance:Ds.origin.distanceTo(y),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var pf=class extends Lt{constructor(e=new ba,t=new ga({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Cv.fromBufferAttribute(t,o),Pv.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Cv.distanceTo(Pv);let r=new Dr(s,2,1);return e.setAttribute("instanceDistanceStart",new rs(r,1,0)),e.setAttribute("instanceDistanceEnd",new rs(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Ds=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;oo=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),df.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=oo*.5;else{let u=Math.max(s.near,df.distanceToPoint(Ds.origin));c=Lv(s,u,l.resolution)}if(df.radius+=c,Ds.intersectsSphere(df)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),ff.copy(a.boundingBox).applyMatrix4(o);let h;if(n)h=oo*.5;else{let u=Math.max(s.near,ff.distanceToPoint(Ds.origin));h=Lv(s,u,l.resolution)}ff.expandByScalar(h),Ds.intersectsBox(ff)!==!1&&(n?P3(this,t):I3(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(pm),this.material.uniforms.resolution.value.set(pm.z,pm.w))}};var L3=.25,D3=1500,N3=3e7,U3=2.5,mf=class{constructor(e,t){this.run=e;this.loading=t}run;loading;object=new Vt;material=new ga({linewidth:U3,vertexColors:!0});lines=null;upTo=[];ways=[];left=0;read="";drawn="";shown=null;key(e,t){return`${e} ${e==="picked"?t:""} ${this.run.frames} ${this.run.summary.manifest.started}`}has(e,t){return this.read===this.key(e,t)}async load(e,t){let{run:n,loading:s}=this,r=this.key(e,t),o=new Map,a=new Map,l=0,c=s.begin("Reading trails","frames",n.frames);try{for(let u=0;u<n.frames;u++){c.got=u;let f=await n.motion(u),d=await n.shape(f.info.shape,u),[p,b,m]=[d.u32("ids"),d.u32("offsets"),d.f32("points")];if(e==="moving"&&p.length*n.frames>N3)throw new Mn(`${p.length.toLocaleString("en")} blocks in ${n.frames} frames are too many for trails.`,"Pick a block and choose its trail alone.");let g=d.info.dimension,x=f.f32("shifts");l=L3*d.info.size,p.forEach((_,y)=>{if(e==="picked"&&_!==t)return;let T=[x[g*y],x[g*y+1],g===3?x[3*y+2]:0],M=Math.hypot(...T),v=o.get(_);v||(v={id:_,frames:[],middles:[],shifts:[]},o.set(_,v),a.set(_,-M)),Number.isFinite(M)&&(v.frames.push(u),v.shifts.push(...T),v.middles.push(...F3(m,b[y],b[y+1])),a.set(_,Math.max(a.get(_),M)))})}}finally{s.end(c)}let h=[...o.values()].filter(u=>e==="picked"||a.get(u.id)>l);h.sort((u,f)=>a.get(f.id)-a.get(u.id)||u.id-f.id),this.ways=h.slice(0,D3),this.left=h.length-this.ways.length,this.read=r,this.drawn=""}draw(e,t,n){let s=`${this.read} ${t} ${n}`;return s!==this.drawn&&this.build(t,n),this.drawn=s,this.lines&&(this.lines.geometry.instanceCount=this.upTo[Math.min(e,this.upTo.length-1)]??0),this.object.visible=!0,this.shown}hide(){this.object.visible=!1}build(e,t){this.lines&&(this.object.remove(this.lines),this.lines.geometry.dispose(),this.lines=null);let n=this.run.summary.times,s=[];for(let{id:h,frames:u,middles:f,shifts:d}of this.ways)for(let p=1;p<u.length;p++){let b=y=>[0,1,2].map(T=>f[3*y+T]+e*d[3*y+T]),[m,g]=[b(p-1),b(p)],x=Math.hypot(...[0,1,2].map(y=>f[3*p+y]-f[3*p-3+y]+d[3*p+y]-d[3*p-3+y])),_=n[u[p]]-n[u[p-1]];s.push({frame:u[p],ends:[...m,...g],speed:_>0?x/_:0,id:h})}s.sort((h,u)=>h.frame-u.frame);let r=s.reduce((h,u)=>Math.max(h,u.speed),0);this.shown={count:this.ways.length,fastest:r,left:this.left},this.upTo=[];for(let{frame:h}of s)this.upTo[h]=(this.upTo[h]??0)+1;for(let h=0,u=0;h<this.run.frames;h++)this.upTo[h]=u+=this.upTo[h]??0;if(s.length===0)return;let o=new ba;o.setPositions(s.flatMap(h=>h.ends));let a=so.turbo,l=h=>t==="block"?lr(h.id):a(.05+.9*h.speed/(r||1)),c=new Xe;o.setColors(s.flatMap(h=>(c.set(l(h)),[c.r,c.g,c.b,c.r,c.g,c.b]))),this.lines=new pf(o,this.material),this.lines.frustumCulled=!1,this.lines.renderOrder=3,s.every(h=>h.ends[2]===0&&h.ends[5]===0)&&(this.lines.position.z=.4),this.object.add(this.lines)}};function F3(i,e,t){let[n,s,r]=[0,0,0];for(let a=3*e;a<3*t;a+=3)n+=i[a],s+=i[a+1],r+=i[a+2];let o=Math.max(1,t-e);return[n/o,s/o,r/o]}function gf(i,e){let t=new Set,n=(s,r)=>{for(let o=s;o<=r;o++)t.add(o)};for(let[,s]of i.matchAll(/`([^`]+)`/g)){let[,r,o]=/^(.*)\.(\d+)$/.exec(s)??[];for(let a of e.blocks){let l=a.count??1;if(a.name===s)n(a.first,a.first+l-1);else if(a.from!==void 0&&a.name===r){let c=Number(o)-a.from;c>=0&&c<l&&n(a.first+c,a.first+c)}}for(let a of e.groups)if(a.name===s)for(let[l,c]of a.blocks)n(l,c)}return[...t].sort((s,r)=>s-r)}var bf="#e8a200",O3=2e3,k3=5e4,B3=9,xf=class{constructor(e,t,n){this.run=e;this.host=t;this.loading=n;this.stage=new lf(t,2),this.stage.onDraw=(s,r)=>this.blocks?.fade(s,r),this.trails=new mf(e,n),this.stage.scene.add(this.trails.object),this.arrows={plane:new Ur(!0),space:new Ur(!1)},this.marks={plane:new da(!0),space:new da(!1)},this.warnedDots.frustumCulled=!1,this.warnedDots.renderOrder=4,this.stage.scene.add(this.warnedDots);for(let s of[...Object.values(this.arrows),...Object.values(this.marks),this.pickedMark,this.supportMark,this.drivenMark,this.warnedMark,this.bolts,this.chains,this.charges,this.stress,this.conditions,this.joints,this.ruler])this.stage.scene.add(s.object)}run;host;loading;stage;scale=new Fu;blocks=null;frame=-1;motion=null;unit="";arrow=null;between=null;trouble=null;picked=null;values=null;arrows;marks;pickedMark=new ro;supportMark=new ro("#2f7bd9",3);drivenMark=new ro("#e07b1a",3);warnedMark=new ro(bf,4);warnedDots=new tr(new gt,new Ts({color:bf,size:10,sizeAttenuation:!1,depthTest:!1,transparent:!0}));bolts=new Hu;chains=new Vu;charges=new Gu;stress=new cf;conditions=new Ku;joints=new Ju;ruler=new Bu;ends=[];conditionNotes=[];warned=0;supports=null;driven=0;boltForces=null;chained=null;stressShown=null;last=null;atRest=new $t;ticket=0;ink="#000000";hasty=!1;trailed=null;notes=[];onChange=null;trails;now=null;others=[];get flat(){return this.blocks?.dimension!==3}get unshaded(){let{blocks:e,stage:t}=this;if(!e||e.dimension===2)return"";if(!e.isSolid)return"No shadows between blocks of glass.";let n=t.tooMany(e);return!n&&!e.crowded?"":`No ${[n?"shadows":"",e.crowded?"edges":""].filter(Boolean).join(" and ")}: ${e.visibleFaces.toLocaleString("en")} faces are too many ${t.software?"without graphics hardware":"for them"}.`}setTheme(e,t){this.stage.background=e;for(let n of Object.values(this.arrows))n.colour=t;this.ink=t,this.blocks?.tint(t),this.stage.redraw()}async show(e,t){let n=++this.ticket;if(this.run.frames===0)return!0;try{let s=await this.fetch(e,t);if(n!==this.ticket)return!1;let r=s.motion.info.shape;if(this.blocks?.shape.info.key!==r){let a=await this.run.shape(r,e);if(n!==this.ticket)return!1;let l=a.u32("ids").length,c=l>k3?await this.loading.announce(`Preparing ${l.toLocaleString("en")} blocks`):null;if(n===this.ticket&&this.build(new Zu(a,this.scale,this.stage.shading.lit,this.stage.software)),c&&this.loading.end(c),n!==this.ticket)return!1;let{conditions:h,blocks:u}={conditions:this.run.conditions,blocks:this.blocks};if(h&&u.ids.some(f=>f>=h.blocks)&&await this.run.readModel(),n!==this.ticket)return!1}let o=this.last===null;this.last=s,this.trouble=null,this.apply(t,!0),o&&this.blocks&&this.stage.look(this.blocks.box().union(this.atRest))}catch(s){if(n!==this.ticket)return!1;this.trouble=ur(s)}return this.frame=e,!0}prefetch(e,t){return this.fetch(e,t).catch(()=>{})}fetch(e,t){return gv(this.run,e,t,this.hasty?null:[this.run,...this.others])}build(e){let t=this.blocks===null,n=this.blocks;n&&(this.stage.scene.remove(n.object),n.dispose()),this.blocks=e,e.tint(this.ink);let s=this.run.summary.manifest.gravity??[0,0,0],r=e.dimension===3&&Math.abs(s[1])>Math.max(Math.abs(s[0]),Math.abs(s[2]))?"y":"z";this.stage.setDimension(e.dimension,r),this.stage.scene.add(e.object),t&&(this.charges.build(this.run.summary.manifest.sources??[],e.shape.info.origin,.3*e.size),this.atRest=e.box(),this.stage.look(this.atRest))}apply(e,t){let{last:n,blocks:s}=this;if(!n||!s)return;let r=this.look(e);this.motion=n.motion,t&&s.move(n.motion,r),this.values=n.field?.f32("values")??null,this.unit=n.field?.info.unit??"",this.tune(e),s.paint(this.values,this.scale),s.reveal(r,this.values),s.glass=(e.cracks||e.chains||e.joints!=="")&&!this.flat,this.stage.shadowed=e.shadows?s:null,this.stage.shading.moved();let{planes:o}=s;for(let l of Object.values(this.marks))l.end(o);this.charges.object.visible=e.charges,this.drawArrows(e),this.drawContacts(e),this.drawBolts(e),this.drawChains(e);let a=e.stress?n.stress:null;this.stressShown=this.stress.draw(a,s,(l,c)=>this.shiftOf(l,1,c),e,this.modelSize()/250),this.drawPicked(),this.drawWarned(),this.drawSupports(e),this.drawConditions(e),this.now=e,this.drawTrails(),this.stage.redraw()}async drawTrails(){let{trails:e,picked:t,now:n}=this;if(this.trailed=null,!n||n.trails===""||n.trails==="picked"&&t===null){e.hide();return}let s=n.trails;if(!e.has(s,t)){e.hide();try{await e.load(s,t)}catch(r){this.trouble=ur(r)}e.has(s,t)&&this.now&&await this.drawTrails(),this.stage.redraw(),this.onChange?.();return}this.trailed=e.draw(this.last.k,n.exaggeration,n.trailColour)}labels(){let{blocks:e,motion:t,now:n,stage:s}=this;return!e||!t||!n?.notes?[]:Mv(this.notes,e,t,n.exaggeration,s.camera)}drawBolts(e){let t=e.bolts?this.last.bolts:null;if(this.boltForces=t?.info??null,!t){this.bolts.clear();return}let n=(s,r)=>this.shiftOf(s,e.exaggeration-1,r);this.bolts.draw(t,this.blocks,n,this.modelSize()/250)}drawChains(e){let t=e.chains?this.last.contacts:null;this.chained=null,this.chains.clear();let n=t?.info.longest??0;if(!t?.has("forces")||!(n>0))return;let s=this.blocks,r=this.contactPlaces(e),o=new I;for(let h=0;h<r.length;h+=3)s.isAway(o.fromArray(r,h))&&(r[h]=NaN);let a=h=>h>=s.count||!s.isShown(h)?null:this.shiftOf(h,e.exaggeration,new I).add(new I().fromArray(s.middles,3*h)),l=.015*this.modelSize()*e.vectorSize,c=this.chains.draw(t,r,a,l);this.chained={count:c,longest:n,unit:t.info.forceUnit??""}}drawSupports(e){let t=e.supports?this.last.supports?.f32("values"):void 0;if(this.supports=null,!t){this.supportMark.draw(null),this.drivenMark.draw(null);return}let n=[[],[]];this.supports=0,this.driven=0;let s=new Map((this.run.conditions?.supports??[]).flatMap(r=>r.blocks.map(o=>[o,r.driven])));t.forEach((r,o)=>{if(!(r>0))return;this.supports++;let a=s.get(this.blocks.ids[o])===!0;if(a&&this.driven++,this.blocks.isShown(o))for(let l of this.blocks.outline(o))n[a?1:0].push(l)}),this.supportMark.draw(new Float32Array(n[0])),this.drivenMark.draw(new Float32Array(n[1]))}drawConditions(e){let{conditions:t}=this.run,n=this.blocks,s=(o,a)=>this.shiftOf(o,e.exaggeration,a),r=o=>o?t:null;this.conditionNotes=[...this.conditions.drawFaces(r(e.boundaries),n),...this.conditions.drawLoads(r(e.loads),n,s,.1*this.modelSize()),...this.conditions.drawWater(r(e.water),n,this.last.motion.info.phase),...this.joints.draw(e.joints,n,t,this.last.materials?.f32("values")??null)]}look(e){return{exaggeration:e.exaggeration,edges:e.edges,clip:rf(this.blocks,e),only:e.only?[this.scale.low,this.scale.high]:null}}cutAway(e){return this.blocks&&bv(this.blocks,e)}cutText(e){return this.blocks?vv(this.blocks,e):""}tune(e){let{scale:t,last:n}=this;if(t.kinds=cr.has(e.field),t.field=e.field,!this.values){t.kinds=!1,t.plain();return}let s=n?.field?.info,r=e.rangeMode==="most"?s?.most??s?.range:s?.range,[o,a]=(e.rangeMode==="frame"?r:n?.range??r)??[0,1];e.rangeMode==="fixed"?[o,a]=[e.low,e.high]:e.map==="blue-red"&&o<0&&a>0&&!e.log&&(a=Math.max(-o,a),o=-a),e.log&&(a=a>0?a:1,o=o>0?o:a*1e-6,o=Math.max(o,a*1e-9)),a>o||(a=o+(Math.abs(o)||1)*1e-6),t.low=o,t.high=a,t.log=e.log,t.paint(e.map)}shiftOf(e,t,n){let s=this.last.motion.f32("shifts");return this.flat?n.set(s[2*e],s[2*e+1],0):n.fromArray(s,3*e),n.multiplyScalar(t)}drawArrows(e){let{last:t,blocks:n}=this;this.arrow=null;let s=this.flat?this.arrows.plane:this.arrows.space,r=new I,o=.08*this.modelSize()*e.vectorSize,a=e.vectors==="seepage flow",l=a?"flows":"forces";if((a||e.vectors==="contact force")&&t.contacts?.has(l)){let c=t.contacts,h=(a?c.info.fastest:c.info.longest)??0,u=this.contactPlaces(e);for(let f=0;f<u.length;f+=3)n.isAway(r.fromArray(u,f))&&(u[f]=NaN);h>0?s.draw(u,c.f32(l),h,o):s.clear(),this.arrow={longest:h,unit:(a?c.info.flowUnit:c.info.forceUnit)??""}}else if(t.vectors){let c=new Float32Array(3*n.count),h=t.vectors.f32("values");for(let f=0;f<n.count;f++){this.shiftOf(f,e.exaggeration,r);for(let p=0;p<3;p++)c[3*f+p]=n.middles[3*f+p]+r.getComponent(p);(!n.isShown(f)||n.isAway(r.fromArray(c,3*f)))&&(c[3*f]=NaN)}let u=t.vectors.info.longest??0;u>0?s.draw(c,h,u,o):s.clear(),this.arrow={longest:u,unit:t.vectors.info.unit}}else s.clear()}modelSize(){let{low:e,high:t}=this.blocks.shape.info;return Math.hypot(t[0]-e[0],t[1]-e[1],t[2]-e[2])||1}contactPlaces(e){return qx(this.last.contacts,this.blocks,(t,n)=>this.shiftOf(t,e.exaggeration-1,n))}drawContacts(e){let t=this.last.contacts,n=this.flat?this.marks.plane:this.marks.space;if(this.between=t?{counts:da.count(t),areas:t.info.areas,unit:t.info.areaUnit}:null,t&&e.contacts?n.drawPoints(t,this.contactPlaces(e),e.states):n.hide("points"),t&&e.cracks&&!this.flat){let s=(r,o)=>this.shiftOf(r,e.exaggeration-1,o);n.drawCracks(t,this.last.cracks,this.blocks,s)}else n.hide("cracks")}drawPicked(){let e=this.picked===null?-1:this.blocks.placeOf(this.picked);this.pickedMark.draw(e<0?null:this.blocks.outline(e))}drawWarned(){let e=this.blocks,{preview:t,warnings:n}=this.run.summary.manifest,s=t?new Set(n.flatMap(c=>gf(c,this.run.names))):new Set;this.warned=s.size;let o=[...s].map(c=>e.placeOf(c)).filter(c=>c>=0&&e.isShown(c)).slice(0,O3),a=o.flatMap(c=>[...e.outline(c)]);this.warnedMark.draw(a.length>0?new Float32Array(a):null);let l=o.flatMap(c=>[...e.middles.subarray(3*c,3*c+2),this.flat?.6:e.middles[3*c+2]]);this.warnedDots.geometry.dispose(),this.warnedDots.geometry.setAttribute("position",new Ke(l,3)),this.warnedDots.visible=l.length>0}goTo(e){let{blocks:t}=this;if(!t)return;let n=new $t;for(let s of e.map(r=>t.placeOf(r)))if(s>=0)for(let r of t.cornersOf(s))n.expandByPoint(r);n.isEmpty()||this.stage.look(n.expandByScalar(n.getSize(new I).length()))}pickAt(e,t){if(!this.blocks)return null;let n=this.blocks.pick(this.stage.ray(e,t));return n===null?null:this.blocks.ids[n]}placeAt(e,t){if(!this.blocks)return null;let n=this.stage.ray(e,t),s=this.blocks.hit(n),r=a=>{let[l,c]=this.stage.onScreen(a);return Math.hypot(l-e,c-t)},o=s?this.blocks.cornersOf(s.block).reduce((a,l)=>r(l)<r(a)?l:a):null;if(o&&r(o)<B3&&!this.blocks.isAway(o))return o;if(this.flat){let{origin:a,direction:l}=n.ray;return a.clone().addScaledVector(l,-a.z/l.z)}return s?.point??null}lay(e){this.ends=e,this.ruler.draw(e,this.flat),this.stage.redraw()}lineText(){let[e,t]=this.ends;if(!e)return"";if(!t)return"line: click its other end";let n=t.clone().sub(e),s=o=>Bt(Math.abs(o)<1e-6*n.length()?0:o,4),r=(this.flat?[n.x,n.y]:n.toArray()).map(s).join(", ");return`distance ${sn(n.length(),"m",5)} (${r})`}along(){let[e,t]=this.ends;return!e||!t||!this.blocks?{pieces:[],length:0}:{pieces:Wx(this.blocks,e,t).filter(n=>this.blocks.isShown(n.block)),length:e.distanceTo(t)}}pick(e){this.picked=e,this.blocks&&this.drawPicked(),this.now?.trails==="picked"&&this.drawTrails(),this.stage.redraw()}niceExaggeration(){let e=this.last?.motion.f32("shifts");if(!e)return 1;let t=this.flat?2:3,n=0;for(let o=0;o<e.length;o+=t)n=Math.max(n,Math.hypot(e[o],e[o+1],t===3?e[o+2]:0));if(!(n>0))return 1;let s=.05*this.modelSize()/n,r=10**Math.floor(Math.log10(s));return Math.max(1,r*Math.floor(s/r))}fit(e){this.blocks&&this.stage.look(this.blocks.box().union(this.conditions.reach),e)}};function vf(i,e){let{scale:t}=i,n={title:"",marks:[],kinds:t.kinds,notes:[]},s=i.blocks?.surveys??[];if(i.values&&e.field)if(t.kinds){n.title=e.field;let c=[...new Set(i.values)].filter(Number.isFinite).sort((h,u)=>h-u);if(c.length<=10){let h=e.field==="material"?s.map(f=>i.values[f]):[],u=f=>h.includes(f)?Ou:lr(f,e.field);n.marks=c.map((f,d)=>({at:d,text:bm(i.run,e.field,f),colour:u(f)}))}}else{let c=Jp(Math.max(Math.abs(t.low),Math.abs(t.high)),i.unit);n.title=e.field+(c.unit?` [${c.unit}]`:""),n.marks=z3(t,c.factor);let h=i.values.filter(u=>t.isBeyond(u)).length;h>0&&n.notes.push({text:`${h} block${h===1?"":"s"} beyond`})}s.length>0&&!t.kinds&&n.notes.push({text:"ground, without the field",colour:Ou}),i.warned>0&&n.notes.push({text:`${i.warned} block${i.warned===1?"":"s"} with warnings`,colour:bf}),i.supports!==null&&n.notes.push({text:`${i.supports} held or moved`,colour:"#2f7bd9"}),i.supports!==null&&i.driven>0&&n.notes.push({text:`${i.driven} of them driven`,colour:"#e07b1a"}),n.notes.push(...i.conditionNotes);let r=(i.run.summary.manifest.sources??[]).map(c=>c.name);if(e.charges&&r.length>0&&n.notes.push({text:r.length===1?`charge ${r[0]}`:`${r.length} charges`,colour:tm}),i.boltForces&&i.boltForces.largest!==null){let{largest:c,smallest:h,unit:u}=i.boltForces;n.notes.push({text:`bolts up to ${sn(c,u,3)}`,colour:"#d01c1c"}),h!==null&&h<0&&n.notes.push({text:`bolts down to ${sn(h,u,3)}`,colour:"#1d5fd0"})}if(i.chained){let{count:c,longest:h,unit:u}=i.chained;n.notes.push({text:`forces of ${c} contacts up to ${sn(h,u,3)}`,colour:em})}if(i.trailed){let{count:c,fastest:h,left:u}=i.trailed,f=`trail${c===1?"":"s"} of ${c} block${c===1?"":"s"}${u>0?` (${u} more)`:""}`;n.notes.push(e.trailColour==="speed"&&h>0?{text:`${f}, up to ${sn(h,"m/s",3)}`,colour:so.turbo(.95)}:{text:f})}if(i.stressShown?.range){let{range:[c,h],longest:u,unit:f,beyond:d}=i.stressShown;c<0&&n.notes.push({text:`compression up to ${sn(-c,f,3)}`,colour:Kl}),h>0&&n.notes.push({text:`tension up to ${sn(h,f,3)}`,colour:Ql}),u!==null&&n.notes.push({text:`longest cross ${sn(u,f,3)}${d>0?`, ${d} beyond`:""}`})}i.arrow&&e.vectors&&n.notes.push({text:`longest ${e.vectors} ${sn(i.arrow.longest,i.arrow.unit,3)}`}),e.exaggeration!==1&&n.notes.push({text:`displacements \xD7 ${Bt(e.exaggeration)}`});let o=i.lineText();o&&n.notes.push({text:o,colour:Kp});let a=i.cutText(e);a&&n.notes.push({text:a});let{between:l}=i;return l&&(e.contacts||e.cracks)&&hr.forEach((c,h)=>{let u=e.contacts&&e.states[h]||e.cracks&&!i.flat&&h>=Wu,f=l.counts[h];if(!u||f===0&&h>1)return;let d=l.unit==="m2"?"m\xB2":l.unit,p=h>=Wu?` (${Bt(l.areas[h],3)} ${d})`:"";n.notes.push({text:`${c.name} ${f}${p}`,colour:c.colour})}),n}function bm(i,e,t){switch(e){case"block":return i.called(t);case"material":return i.summary.manifest.materials?.[t]??Bt(t);case"held":return t>0?"held or driven":"free";case"surface":return t>0?"at the surface":"inside";case"removable_type":return["inside, or ground","key block","held by strength","held by weight","tapered"][t]??Bt(t);case"removable_mode":return["not removable","stays","slides on one plane","slides on two planes","falls"][t]??Bt(t);case"level":return t>0?`split ${Bt(t)} times`:"not split";default:return Bt(t)}}function z3(i,e){let{low:t,high:n}=i;if(i.log){let r=[],o=Math.ceil(Math.log10(t)-1e-9),a=Math.floor(Math.log10(n)+1e-9),l=Math.max(1,Math.ceil((a-o)/5));for(let c=o;c<=a;c+=l){let h=(c-Math.log10(t))/(Math.log10(n)-Math.log10(t));r.push({at:h,text:Bt(10**c*e,3)})}return r}return Gx(t*e,n*e,4).map(r=>({at:(r/e-t)/(n-t),text:Bt(r,4)}))}function Dv(i,e){let t=Z("div.legend");if(i.title&&t.append(Z("div.title",{},i.title)),i.kinds)for(let n of i.marks){let s=Z("i.chip");s.style.background=n.colour??"",t.append(Z("div.note",{},s,n.text))}else if(i.marks.length>0){let n=Z("div.strip"),s=Array.from({length:17},(o,a)=>e.css(a/16));n.style.background=`linear-gradient(to top, ${s.join(",")})`;let r=Z("div.scale",{},n);for(let o of i.marks){let a=Z("span.tick",{},o.text);a.style.bottom=`${100*o.at}%`,r.append(a)}t.append(r)}for(let n of i.notes){let s=n.colour?Z("i.chip"):null;s&&(s.style.background=n.colour),t.append(Z("div.note",{},s,n.text))}return t}function Nv(i,e,t,[n,s],r,o){i.textBaseline="middle",i.font=`600 ${12*r}px system-ui, sans-serif`,i.fillStyle=o;let a=s+10*r;e.title&&(i.fillText(e.title,n,a),a+=16*r),i.font=`${11*r}px system-ui, sans-serif`;let l=c=>{i.fillStyle=c,i.fillRect(n,a-5*r,10*r,10*r),i.fillStyle=o};if(e.kinds)for(let c of e.marks)l(c.colour??o),i.fillText(c.text,n+16*r,a),a+=15*r;else if(e.marks.length>0){let c=140*r,h=i.createLinearGradient(0,a+c,0,a);for(let u=0;u<=16;u++)h.addColorStop(u/16,t.css(u/16));i.fillStyle=h,i.fillRect(n,a,14*r,c),i.fillStyle=o;for(let u of e.marks)i.fillText(u.text,n+20*r,a+c*(1-u.at));a+=c+14*r}for(let c of e.notes)c.colour&&l(c.colour),i.fillText(c.text,c.colour?n+16*r:n,a),a+=15*r}var St={EBML:440786851,EBMLVersion:17030,EBMLReadVersion:17143,EBMLMaxIDLength:17138,EBMLMaxSizeLength:17139,DocType:17026,DocTypeVersion:17031,DocTypeReadVersion:17029,Segment:408125543,Info:357149030,TimestampScale:2807729,Duration:17545,MuxingApp:19840,WritingApp:22337,Tracks:374648427,TrackEntry:174,TrackNumber:215,TrackUID:29637,TrackType:131,FlagLacing:156,CodecID:134,DefaultDuration:2352003,Video:224,PixelWidth:176,PixelHeight:186,Cues:475249515,CuePoint:187,CueTime:179,CueTrackPositions:183,CueTrack:247,CueClusterPosition:241,Cluster:524531317,Timestamp:231,SimpleBlock:163},H3=3e4;function xm(i){let e=new Uint8Array(i.reduce((n,s)=>n+s.length,0)),t=0;for(let n of i)e.set(n,t),t+=n.length;return e}function vm(i,e=1){let t=[];for(let n=i;n>0||t.length<e;n=Math.floor(n/256))t.unshift(n%256);return Uint8Array.from(t)}function Ei(i,...e){let t=vm(e.reduce((n,s)=>n+s.length,0),8);return t[0]=1,xm([vm(i),t,...e])}function Vn(i,e,t=1){return Ei(i,vm(e,t))}function yf(i,e){return Ei(i,new TextEncoder().encode(e))}function V3(i,e){let t=new Uint8Array(8);return new DataView(t.buffer).setFloat64(0,e),Ei(i,t)}function G3(i){let e=n=>Math.round(1e3*n/i.framesPerSecond),t=[];return i.frames.forEach((n,s)=>{let r=t.at(-1);(r===void 0||n.key||e(s)-e(r)>H3)&&t.push(s)}),t.map((n,s)=>{let r=e(n),o=i.frames.slice(n,t[s+1]).map((a,l)=>{let c=e(n+l)-r,h=Uint8Array.from([129,c>>8,c&255,a.key?128:0]);return Ei(St.SimpleBlock,h,a.data)});return{start:r,bytes:Ei(St.Cluster,Vn(St.Timestamp,r),...o)}})}function Uv(i){let{width:e,height:t,codec:n,framesPerSecond:s,frames:r}=i,o=Ei(St.EBML,Vn(St.EBMLVersion,1),Vn(St.EBMLReadVersion,1),Vn(St.EBMLMaxIDLength,4),Vn(St.EBMLMaxSizeLength,8),yf(St.DocType,"webm"),Vn(St.DocTypeVersion,4),Vn(St.DocTypeReadVersion,2)),a=Ei(St.Info,Vn(St.TimestampScale,1e6),V3(St.Duration,1e3*r.length/s),yf(St.MuxingApp,"riprap"),yf(St.WritingApp,"riprap")),l=Ei(St.TrackEntry,Vn(St.TrackNumber,1),Vn(St.TrackUID,1),Vn(St.TrackType,1),Vn(St.FlagLacing,0),yf(St.CodecID,n),Vn(St.DefaultDuration,Math.round(1e9/s)),Ei(St.Video,Vn(St.PixelWidth,e),Vn(St.PixelHeight,t))),c=xm([a,Ei(St.Tracks,l)]),h=G3(i),u=p=>Ei(St.Cues,...h.map(({start:b},m)=>Ei(St.CuePoint,Vn(St.CueTime,b),Ei(St.CueTrackPositions,Vn(St.CueTrack,1),Vn(St.CueClusterPosition,p[m],8))))),f=c.length+u(h.map(()=>0)).length,d=h.map(({bytes:p})=>(f+=p.length)-p.length);return xm([o,Ei(St.Segment,c,u(d),...h.map(p=>p.bytes))])}var Fv=2e3;function ym(i,e,t=document.createElement("canvas")){let n=i[0].stage.renderer.getPixelRatio(),s=getComputedStyle(document.documentElement),r=s.getPropertyValue("--ink").trim(),o=s.getPropertyValue("--paper").trim(),a=Math.round(26*n);for(let{stage:d}of i)d.stand(),d.draw();let l=i.map(d=>[d.stage.canvas.width,d.stage.canvas.height]),c=l.reduce((d,p)=>d+p[0],0)&-2,h=Math.max(...l.map(d=>d[1]))+a&-2;(t.width!==c||t.height!==h)&&(t.width=c,t.height=h);let u=t.getContext("2d");u.fillStyle=o,u.fillRect(0,0,c,h);let f=0;return i.forEach((d,p)=>{u.drawImage(d.stage.canvas,f,a);let{manifest:b}=d.run.summary,m=d.run.saidAt(d.frame);u.fillStyle=r,u.textBaseline="middle",u.font=`600 ${13*n}px system-ui, sans-serif`,u.fillText(`${b.title||d.run.summary.name}   ${m}`,f+12*n,a/2,l[p][0]-24*n),Nv(u,vf(d,e),d.scale,[f+14*n,a+8*n],n,r),Av(u,d.labels(),[f,a,...l[p]],n,[r,o]),f+=l[p][0]}),t}function Ov(i){return new Promise((e,t)=>{i.toBlob(n=>n?e(n):t(new Error("the browser made no picture")),"image/png")})}function _m(i){return i.map(e=>e.run.summary.name.replace(/\.run$/,"")).join("_")}async function wm(i,e){let t=await Ov(ym(i,e));yr(t,`${_m(i)}_${String(i[0].frame+1).padStart(6,"0")}.png`)}var W3=120;async function kv([i,e,t,n],s,r){t.pause();let o=t.at,a=i[0].stage.standpoint(),l=f=>i.forEach(d=>d.stage.follow(f)),c=document.createElement("canvas"),h=t.moments.length,u=n&&h===1?W3:h;try{for(let f=0;f<u;f++){if(!s(f/u))return!1;f<h&&await t.go(f),n&&l(n(f/Math.max(1,u-1))),await r(ym(i,e,c),f,u)}}finally{n&&l(a),await t.go(o)}return!0}async function X3(i,e){let t={};await kv(i,e,async(s,r,o)=>{if(o>Fv)throw new Error(`${o} frames are too many for one zip, which has at most ${Fv}: riprap shot RUN --all -o FILE.png writes them to a folder.`);let a=await Ov(s);t[`frame_${String(r+1).padStart(6,"0")}.png`]=[new Uint8Array(await a.arrayBuffer()),{level:0}]})&&yr(new Blob([Hg(t)],{type:"application/zip"}),`${_m(i[0])}_frames.zip`)}var q3=[["vp09.00.51.08","V_VP9"],["vp8","V_VP8"]],$3=50,Y3=4;async function j3(i,e,t){if(typeof VideoEncoder>"u"){let s=window.isSecureContext?"This browser has no video encoder (WebCodecs).":"Browsers encode video only on pages of this machine (127.0.0.1) or served by https.";throw new Error(`${s} Save all frames as PNG instead, or write the film without a browser: riprap shot RUN --all -o film.apng`)}let n=Math.max(2e6,Math.round(.35*i*e*t));for(let[s,r]of q3){let o={codec:s,width:i,height:e,framerate:t,bitrate:n,latencyMode:"quality"};if((await VideoEncoder.isConfigSupported(o)).supported)return[o,r]}throw new Error(`This browser cannot encode VP9 or VP8 at ${i} x ${e} pixels. Make the window smaller, or save all frames as PNG instead.`)}async function Z3(i,e){let t=i[1].speed,n=[],s={},r=()=>{if(s.failed)throw new Error(`The browser could not encode the film: ${s.failed.message}`)},o=async({width:l,height:c})=>{let[h,u]=await j3(l,c,t);s.film={width:l,height:c,codec:u,framesPerSecond:t,frames:n};let f=new VideoEncoder({output:d=>{let p=new Uint8Array(d.byteLength);d.copyTo(p),n.push({data:p,key:d.type==="key"})},error:d=>s.failed=d});return f.configure(h),s.encoder=f},a=0;try{let l=await kv(i,e,async(c,h,u)=>{a=u;let f=s.encoder??await o(c);if(c.width!==s.film.width||c.height!==s.film.height)throw new Error("The window changed its size while the film was made. Make it again and leave the window as it is.");let d=new VideoFrame(c,{timestamp:Math.round(1e6*h/t),duration:Math.round(1e6/t)});for(r(),f.encode(d,{keyFrame:h%$3===0}),d.close();f.encodeQueueSize>Y3&&!s.failed;)await new Promise(p=>setTimeout(p,5))});if(r(),!l||!s.film)return;if(await s.encoder.flush(),r(),n.length!==a)throw new Error(`The browser encoded ${n.length} of ${a} frames. Save all frames as PNG instead.`);yr(new Blob([Uv(s.film)],{type:"video/webm"}),`${_m(i[0])}.webm`)}finally{s.encoder&&s.encoder.state!=="closed"&&s.encoder.close()}}function Bv(i,e){let t=new Map(i.flatMap(n=>n.keys.map(s=>[s,n])));document.addEventListener("keydown",n=>{if(document.querySelector("dialog[open]"))return;let s=e.matches(":hover")||e.contains(document.activeElement);if(e.classList.contains("replay")&&!s||n.ctrlKey||n.metaKey||n.altKey)return;let r=n.target;if(r instanceof HTMLSelectElement||r instanceof HTMLInputElement&&["number","text"].includes(r.type)||r instanceof HTMLInputElement&&r.type==="range"&&n.key.startsWith("Arrow")||r instanceof HTMLButtonElement&&(n.key===" "||n.key==="Enter"))return;let l=t.get(n.key.length===1?n.key.toLowerCase():n.key);l&&(n.preventDefault(),l.act(n.shiftKey))})}function zv(i){let e=Z("dialog.sheet",{"aria-label":"keyboard shortcuts"}),t=i.map(s=>Z("tr",{},Z("td",{},Z("kbd",{},s.label)),Z("td",{},s.what))),n=[["drag","rotate (in the plane: move)"],["right drag","move"],["wheel, pinch","zoom"],["click","pick a block; after d an end of the line"],["click in a plot","go to that time"]];return e.append(Z("h2",{},"Keys and mouse"),Z("div.columns",{},Z("table",{},...t),Z("table",{},...n.map(([s,r])=>Z("tr",{},Z("td",{},Z("kbd",{},s)),Z("td",{},r))))),Z("button",{type:"button",onclick:()=>e.close()},"Close")),e.addEventListener("click",s=>{s.target===e&&e.close()}),e}var J3="uplot",K3="u-hz",Q3="u-vt",eR="u-title",tR="u-wrap",nR="u-under",iR="u-over",sR="u-axis",co="u-off",rR="u-select",oR="u-cursor-x",aR="u-cursor-y",lR="u-cursor-pt",cR="u-legend",hR="u-live",uR="u-inline",fR="u-series",dR="u-marker",Hv="u-label",pR="u-value",nc="width",ic="height";var Vv="bottom",xa="left",Mm="right",Hm="#000",Gv=Hm+"0",Em="mousemove",Wv="mousedown",Tm="mouseup",Xv="mouseenter",qv="mouseleave",$v="dblclick",mR="resize",gR="scroll",Yv="change",Ef="dppxchange",Vm="--",Ea=typeof window<"u",Im=Ea?document:null,ya=Ea?window:null,bR=Ea?navigator:null,Ct,_f;function Lm(){let i=devicePixelRatio;Ct!=i&&(Ct=i,_f&&Nm(Yv,_f,Lm),_f=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),ho(Yv,_f,Lm),ya.dispatchEvent(new CustomEvent(Ef)))}function Oi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Dm(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Qt(i,e,t){i.style[e]=t+"px"}function hs(i,e,t,n){let s=Im.createElement(i);return e!=null&&Oi(s,e),t?.insertBefore(s,n),s}function ji(i,e){return hs("div",i,e)}var jv=new WeakMap;function Ns(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=jv.get(i);r!=o&&(i.style.transform=r,jv.set(i,r),e<0||t<0||e>n||t>s?Oi(i,co):Dm(i,co))}var Zv=new WeakMap;function Jv(i,e,t){let n=e+t,s=Zv.get(i);n!=s&&(Zv.set(i,n),i.style.background=e,i.style.borderColor=t)}var Kv=new WeakMap;function Qv(i,e,t,n){let s=e+""+t,r=Kv.get(i);s!=r&&(Kv.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Gm={passive:!0},xR={...Gm,capture:!0};function ho(i,e,t,n){e.addEventListener(i,t,n?xR:Gm)}function Nm(i,e,t,n){e.removeEventListener(i,t,Gm)}Ea&&Lm();function us(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:ki((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Ay(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Ry=i=>i!=null,Cy=i=>i!=null&&i>0,Rf=Ay(Ry),vR=Ay(Cy);function yR(i,e,t,n=0,s=!1){let r=s?vR:Rf,o=s?Cy:Ry;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Gt,l??-Gt]}function Cf(i,e,t,n){let s=ny(i),r=ny(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?fr:Py,a=s==1?ki:Zi,l=r==1?Zi:ki,c=a(o(Dn(i))),h=l(o(Dn(e))),u=_a(t,c),f=_a(t,h);return t==10&&(c<0&&(u=Wt(u,-c)),h<0&&(f=Wt(f,-h))),n||t==2?(i=u*s,e=f*r):(i=Ny(i,u),e=Pf(e,f)),[i,e]}function Wm(i,e,t,n){let s=Cf(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Xm=.1,ey={mode:3,pad:Xm},rc={pad:0,soft:null,mode:0},_R={min:rc,max:rc};function Tf(i,e,t,n){return If(t)?ty(i,e,t):(rc.pad=t,rc.soft=n?0:null,rc.mode=n?3:0,ty(i,e,_R))}function Et(i,e){return i??e}function wR(i,e,t){for(e=Et(e,0),t=Et(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function ty(i,e,t){let n=t.min,s=t.max,r=Et(n.pad,0),o=Et(s.pad,0),a=Et(n.hard,-Gt),l=Et(s.hard,Gt),c=Et(n.soft,Gt),h=Et(s.soft,-Gt),u=Et(n.mode,0),f=Et(s.mode,0),d=e-i,p=fr(d),b=xi(Dn(i),Dn(e)),m=fr(b),g=Dn(m-p);(d<1e-24||g>10)&&(d=0,(i==0||e==0)&&(d=1e-24,u==2&&c!=Gt&&(r=0),f==2&&h!=-Gt&&(o=0)));let x=d||b||1e3,_=fr(x),y=_a(10,ki(_)),T=x*(d==0?i==0?.1:1:r),M=Wt(Ny(i-T,y/10),24),v=i>=c&&(u==1||u==3&&M<=c||u==2&&M>=c)?c:Gt,S=xi(a,M<v&&i>=v?v:fs(v,M)),C=x*(d==0?e==0?.1:1:o),P=Wt(Pf(e+C,y/10),24),L=e<=h&&(f==1||f==3&&P>=h||f==2&&P<=h)?h:-Gt,O=fs(l,P>L&&e<=L?L:xi(L,P));return S==O&&S==0&&(O=100),[S,O]}var SR=new Intl.NumberFormat(Ea?bR.language:"en-US"),qm=i=>SR.format(i),Bi=Math,Mf=Bi.PI,Dn=Bi.abs,ki=Bi.floor,Ln=Bi.round,Zi=Bi.ceil,fs=Bi.min,xi=Bi.max,_a=Bi.pow,ny=Bi.sign,fr=Bi.log10,Py=Bi.log2,MR=(i,e=1)=>Bi.sinh(i)*e,Am=(i,e=1)=>Bi.asinh(i/e),Gt=1/0;function iy(i){return(fr((i^i>>31)-(i>>31))|0)+1}function Um(i,e,t){return fs(xi(i,e),t)}function Iy(i){return typeof i=="function"}function _t(i){return Iy(i)?i:()=>i}var ER=()=>{},Ly=i=>i,Dy=(i,e)=>e,TR=i=>null,sy=i=>!0,ry=(i,e)=>i==e,AR=/\.\d*?(?=9{6,}|0{6,})/gm,uo=i=>{if(Fy(i)||Or.has(i))return i;let e=`${i}`,t=e.match(AR);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${uo(s)}e${r}`}return Wt(i,n)};function ao(i,e){return uo(Wt(uo(i/e))*e)}function Pf(i,e){return uo(Zi(uo(i/e))*e)}function Ny(i,e){return uo(ki(uo(i/e))*e)}function Wt(i,e=0){if(Fy(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Ln(n)/t}var Or=new Map;function Uy(i){return((""+i).split(".")[1]||"").length}function ac(i,e,t,n){let s=[],r=n.map(Uy);for(let o=e;o<t;o++){let a=Dn(o),l=Wt(_a(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Wt(h,u);s.push(f),Or.set(f,u)}}return s}var oc={},$m=[],wa=[null,null],Fr=Array.isArray,Fy=Number.isInteger,RR=i=>i===void 0;function oy(i){return typeof i=="string"}function If(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function CR(i){return i!=null&&typeof i=="object"}var PR=Object.getPrototypeOf(Uint8Array),Oy="__proto__";function Sa(i,e=If){let t;if(Fr(i)){let n=i.find(s=>s!=null);if(Fr(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Sa(i[s],e)}else t=i.slice()}else if(i instanceof PR)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Oy&&(t[n]=Sa(i[n],e))}else t=i;return t}function En(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Oy&&(If(i[s])?En(i[s],Sa(n[s])):i[s]=Sa(n[s]))}return i}var IR=0,LR=1,DR=2;function NR(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function UR(i,e){if(kR(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return BR(o[0])||(o=OR(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=e?e[o][c]:LR,d=[];for(let p=0;p<h.length;p++){let b=h[p],m=r.get(l[p]);b===null?f!=IR&&(u[m]=b,f==DR&&d.push(m)):u[m]=b}NR(u,d,s),n.push(u)}}return n}var FR=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function OR(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function kR(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function BR(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=xi(1,ki((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var ky=["January","February","March","April","May","June","July","August","September","October","November","December"],By=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function zy(i){return i.slice(0,3)}var zR=By.map(zy),HR=ky.map(zy),VR={MMMM:ky,MMM:HR,WWWW:By,WWW:zR};function tc(i){return(i<10?"0":"")+i}function GR(i){return(i<10?"00":i<100?"0":"")+i}var WR={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>tc(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>tc(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>tc(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>tc(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>tc(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>GR(i.getMilliseconds())};function Ym(i,e){e=e||VR;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?WR[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var XR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function qR(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==XR?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Hy=i=>i%1==0,Af=[1,2,2.5,5],$R=ac(10,-32,0,Af),Vy=ac(10,0,32,Af),YR=Vy.filter(Hy),lo=$R.concat(Vy),jm=`
`,Gy="{YYYY}",ay=jm+Gy,Wy="{M}/{D}",sc=jm+Wy,wf=sc+"/{YY}",Xy="{aa}",jR="{h}:{mm}",va=jR+Xy,ly=jm+va,cy=":{ss}",Dt=null;function qy(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?ac(10,0,3,Af).filter(Hy):ac(10,-3,0,Af)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Gy,Dt,Dt,Dt,Dt,Dt,Dt,1],[s*28,"{MMM}",ay,Dt,Dt,Dt,Dt,Dt,1],[s,Wy,ay,Dt,Dt,Dt,Dt,Dt,1],[n,"{h}"+Xy,wf,Dt,sc,Dt,Dt,Dt,1],[t,va,wf,Dt,sc,Dt,Dt,Dt,1],[e,cy,wf+" "+va,Dt,sc+" "+va,Dt,ly,Dt,1],[i,cy+".{fff}",wf+" "+va,Dt,sc+" "+va,Dt,ly,Dt,1]];function h(u){return(f,d,p,b,m,g)=>{let x=[],_=m>=o,y=m>=r&&m<o,T=u(p),M=Wt(T*i,3),v=Rm(T.getFullYear(),_?0:T.getMonth(),y||_?1:T.getDate()),S=Wt(v*i,3);if(y||_){let C=y?m/r:0,P=_?m/o:0,L=M==S?M:Wt(Rm(v.getFullYear()+P,v.getMonth()+C,1)*i,3),O=new Date(Ln(L/i)),z=O.getFullYear(),U=O.getMonth();for(let G=0;L<=b;G++){let q=Rm(z+P*G,U+C*G,1),H=q-u(Wt(q*i,3));L=Wt((+q+H)*i,3),L<=b&&x.push(L)}}else{let C=m>=s?s:m,P=ki(p)-ki(M),L=S+P+Pf(M-S,C);x.push(L);let O=u(L),z=O.getHours()+O.getMinutes()/t+O.getSeconds()/n,U=m/n,G=f.axes[d]._space,q=g/G;for(;L=Wt(L+m,i==1?0:3),!(L>b);)if(U>1){let H=ki(Wt(z+U,6))%24,ee=u(L).getHours()-H;ee>1&&(ee=-1),L-=ee*n,z=(z+U)%24;let te=x[x.length-1];Wt((L-te)/m,3)*q>=.7&&x.push(L)}else x.push(L)}return x}}return[l,c,h]}var[ZR,JR,KR]=qy(1),[QR,eC,tC]=qy(.001);ac(2,-53,53,[1]);function hy(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function uy(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,h,u,f,d;return n.map(p=>{let b=i(p),m=b.getFullYear(),g=b.getMonth(),x=b.getDate(),_=b.getHours(),y=b.getMinutes(),T=b.getSeconds(),M=m!=l&&a[2]||g!=c&&a[3]||x!=h&&a[4]||_!=u&&a[5]||y!=f&&a[6]||T!=d&&a[7]||a[1];return l=m,c=g,h=x,u=_,f=y,d=T,M(b)})}}function nC(i,e){let t=Ym(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Rm(i,e,t){return new Date(i,e,t)}function fy(i,e){return e(i)}var iC="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function dy(i,e){return(t,n,s,r)=>r==null?Vm:e(i(n))}function sC(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function rC(i,e){return i.series[e].fill(i,e)}var oC={show:!0,live:!0,isolate:!1,mount:ER,markers:{show:!0,width:2,stroke:sC,fill:rC,dash:"solid"},idx:null,idxs:null,values:[]};function aC(i,e){let t=i.cursor.points,n=ji(),s=t.size(i,e);Qt(n,nc,s),Qt(n,ic,s);let r=s/-2;Qt(n,"marginLeft",r),Qt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Qt(n,"borderWidth",o),n}function lC(i,e){let t=i.series[e].points;return t._fill||t._stroke}function cC(i,e){let t=i.series[e].points;return t._stroke||t._fill}function hC(i,e){return i.series[e].points.size}var Cm=[0,0];function uC(i,e,t){return Cm[0]=e,Cm[1]=t,Cm}function Sf(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Pm(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var fC={show:!0,x:!0,y:!0,lock:!1,move:uC,points:{one:!1,show:aC,size:hC,width:0,stroke:cC,fill:lC},bind:{mousedown:Sf,mouseup:Sf,click:Sf,dblclick:Sf,mousemove:Pm,mouseleave:Pm,mouseenter:Pm},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},$y={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Zm=En({},$y,{filter:Dy}),Yy=En({},Zm,{size:10}),jy=En({},$y,{show:!1}),Jm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Zy="bold "+Jm,Jy=1.5,py={show:!0,scale:"x",stroke:Hm,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Zy,side:2,grid:Zm,ticks:Yy,border:jy,font:Jm,lineGap:Jy,rotate:0},dC="Value",pC="Time",my={show:!0,scale:"x",auto:!1,sorted:1,min:Gt,max:-Gt,idxs:[]};function mC(i,e,t,n,s){return e.map(r=>r==null?"":qm(r))}function gC(i,e,t,n,s,r,o){let a=[],l=Or.get(s)||0;t=o?t:Wt(Pf(t,s),l);for(let c=t;c<=n;c=Wt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Fm(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?fr:Py,h=ki(c(t));s=_a(l,h),l==10&&(s=lo[us(s,lo)]);let u=t,f=s*l;l==10&&(f=lo[us(f,lo)]);do a.push(u),u=u+s,l==10&&!Or.has(u)&&(u=Wt(u,Or.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=lo[us(f,lo)]));while(u<=n);return a}function bC(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Fm(i,e,xi(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?Fm(i,e,xi(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(h,c)}var Ky=/./,xC=/[12357]/,vC=/[125]/,gy=/1/,Om=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function yC(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Ky:l(7,o)-h>=c?xC:l(5,o)-h>=c?vC:gy;if(u==gy){let f=Dn(l(1,o)-h);if(f<c)return Om(e.slice().reverse(),a.distr,u,Zi(c/f)).reverse()}return Om(e,a.distr,u,1)}function _C(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=Dn(l(1,o)-l(2,o));return c<a?Om(e.slice().reverse(),3,Ky,Zi(a/c)).reverse():e}function wC(i,e,t,n){return n==null?Vm:e==null?"":qm(e)}var by={show:!0,scale:"y",stroke:Hm,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Zy,side:3,grid:Zm,ticks:Yy,border:jy,font:Jm,lineGap:Jy,rotate:0};function SC(i,e){let t=3+(i||1)*2;return Wt(t*e,3)}function MC(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=Dn(o-r),l=i.series[e],c=a/(l.points.space*Ct);return n[1]-n[0]<=c}var xy={scale:null,auto:!0,sorted:0,min:Gt,max:-Gt},Qy=(i,e,t,n,s)=>s,vy={show:!0,auto:!0,sorted:0,gaps:Qy,alpha:1,facets:[En({},xy,{scale:"x"}),En({},xy,{scale:"y"})]},yy={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Qy,alpha:1,points:{show:MC,filter:null},values:null,min:Gt,max:-Gt,idxs:[],path:null,clip:null};function EC(i,e,t,n,s){return t/10}var e_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},TC=En({},e_,{time:!1,ori:1}),_y={};function t_(i,e){let t=_y[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(_y[i]=t)),t}var Ma=1,km=2;function fo(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,p=a.width,b=a.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,g,f,d,p,b,Df,Ta,Uf,i_,r_):t(s,l,c,h,u,g,m,d,f,b,p,Nf,Aa,eg,s_,o_)}function Km(i,e){let t=0,n=0,s=Et(i.bands,$m);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function AC(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function dr(i,e,t,n,s,r){return fo(i,e,(o,a,l,c,h,u,f,d,p,b,m)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),_=c.ori==0?Ta:Aa,y,T;x==1?(y=t,T=n):(y=n,T=t);let M=g(u(a[y],c,b,d)),v=g(f(l[y],h,m,p)),S=g(u(a[T],c,b,d)),C=g(f(r==1?h.max:h.min,h,m,p)),P=new Path2D(s);return _(P,S,C),_(P,M,C),_(P,M,v),P})}function Lf(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Uf:eg,l=t;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function RC(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Qm(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(i[u]),p=f==u?d:r(i[f]),b=u-s;d=o<=0&&b>=0&&b<l?r(i[b]):d;let g=f+s;p=o>=0&&g>=0&&g<l?r(i[g]):p,p>=d&&a.push([d,p])}return a}function wy(i){return i==0?Ly:i==1?Ln:e=>ao(e,i)}function n_(i){let e=i==0?Df:Nf,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=fs(c,a/2,l/2),h=fs(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Df=(i,e,t)=>{i.moveTo(e,t)},Nf=(i,e,t)=>{i.moveTo(t,e)},Ta=(i,e,t)=>{i.lineTo(e,t)},Aa=(i,e,t)=>{i.lineTo(t,e)},Uf=n_(0),eg=n_(1),i_=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},s_=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},r_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},o_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function a_(i){return(e,t,n,s,r)=>fo(e,t,(o,a,l,c,h,u,f,d,p,b,m)=>{let{pxRound:g,points:x}=o,_,y;c.ori==0?(_=Df,y=i_):(_=Nf,y=s_);let T=Wt(x.width*Ct,3),M=(x.size-x.width)/2*Ct,v=Wt(M*2,3),S=new Path2D,C=new Path2D,{left:P,top:L,width:O,height:z}=e.bbox;Uf(C,P-v,L-v,O+v*2,z+v*2);let U=G=>{if(l[G]!=null){let q=g(u(a[G],c,b,d)),H=g(f(l[G],h,m,p));_(S,q+M,H),y(S,q,H,M,0,Mf*2)}};if(r)r.forEach(U);else for(let G=n;G<=s;G++)U(G);return{stroke:T>0?S:null,fill:S,clip:C,flags:Ma|km}})}function l_(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var CC=l_(Ta),PC=l_(Aa);function c_(i){let e=Et(i?.alignGaps,0);return(t,n,s,r)=>fo(t,n,(o,a,l,c,h,u,f,d,p,b,m)=>{[s,r]=Rf(l,s,r);let g=o.pxRound,x=z=>g(u(z,c,b,d)),_=z=>g(f(z,h,m,p)),y,T;c.ori==0?(y=Ta,T=CC):(y=Aa,T=PC);let M=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ma},S=v.stroke,C=!1;if(r-s>=b*4){let z=ce=>t.posToVal(ce,c.key,!0),U=null,G=null,q,H,ae,Y=x(a[M==1?s:r]),ee=x(a[s]),te=x(a[r]),de=z(M==1?ee+1:te-1);for(let ce=M==1?s:r;ce>=s&&ce<=r;ce+=M){let K=a[ce],ge=(M==1?K<de:K>de)?Y:x(K),Me=l[ce];ge==Y?Me!=null?(H=Me,U==null?(y(S,ge,_(H)),q=U=G=H):H<U?U=H:H>G&&(G=H)):Me===null&&(C=!0):(U!=null&&T(S,Y,_(U),_(G),_(q),_(H)),Me!=null?(H=Me,y(S,ge,_(H)),U=G=q=H):(U=G=null,Me===null&&(C=!0)),Y=ge,de=z(Y+M))}U!=null&&U!=G&&ae!=Y&&T(S,Y,_(U),_(G),_(q),_(H))}else for(let z=M==1?s:r;z>=s&&z<=r;z+=M){let U=l[z];U===null?C=!0:U!=null&&y(S,x(a[z]),_(U))}let[L,O]=Km(t,n);if(o.fill!=null||L!=0){let z=v.fill=new Path2D(S),U=o.fillTo(t,n,o.min,o.max,L),G=_(U),q=x(a[s]),H=x(a[r]);M==-1&&([H,q]=[q,H]),y(z,H,G),y(z,q,G)}if(!o.spanGaps){let z=[];C&&z.push(...Qm(a,l,s,r,M,x,e)),v.gaps=z=o.gaps(t,n,s,r,z),v.clip=Lf(z,c.ori,d,p,b,m)}return O!=0&&(v.band=O==2?[dr(t,n,s,r,S,-1),dr(t,n,s,r,S,1)]:dr(t,n,s,r,S,O)),v})}function IC(i){let e=Et(i.align,1),t=Et(i.ascDesc,!1),n=Et(i.alignGaps,0),s=Et(i.extend,!1);return(r,o,a,l)=>fo(r,o,(c,h,u,f,d,p,b,m,g,x,_)=>{[a,l]=Rf(u,a,l);let y=c.pxRound,{left:T,width:M}=r.bbox,v=ee=>y(p(ee,f,x,m)),S=ee=>y(b(ee,d,_,g)),C=f.ori==0?Ta:Aa,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ma},L=P.stroke,O=f.dir*(f.ori==0?1:-1),z=S(u[O==1?a:l]),U=v(h[O==1?a:l]),G=U,q=U;s&&e==-1&&(q=T,C(L,q,z)),C(L,U,z);for(let ee=O==1?a:l;ee>=a&&ee<=l;ee+=O){let te=u[ee];if(te==null)continue;let de=v(h[ee]),ce=S(te);e==1?C(L,de,z):C(L,G,ce),C(L,de,ce),z=ce,G=de}let H=G;s&&e==1&&(H=T+M,C(L,H,z));let[ae,Y]=Km(r,o);if(c.fill!=null||ae!=0){let ee=P.fill=new Path2D(L),te=c.fillTo(r,o,c.min,c.max,ae),de=S(te);C(ee,H,de),C(ee,q,de)}if(!c.spanGaps){let ee=[];ee.push(...Qm(h,u,a,l,O,v,n));let te=c.width*Ct/2,de=t||e==1?te:-te,ce=t||e==-1?-te:te;ee.forEach(K=>{K[0]+=de,K[1]+=ce}),P.gaps=ee=c.gaps(r,o,a,l,ee),P.clip=Lf(ee,f.ori,m,g,x,_)}return Y!=0&&(P.band=Y==2?[dr(r,o,a,l,L,-1),dr(r,o,a,l,L,1)]:dr(r,o,a,l,L,Y)),P})}function Sy(i,e,t,n,s,r,o=Gt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=Dn(i[l]-i[a]);h<c&&(c=h,o=Dn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function LC(i){i=i||oc;let e=Et(i.size,[.6,Gt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_t(s),o=1-e[0],a=Et(e[1],Gt),l=Et(e[2],1),c=Et(i.disp,oc),h=Et(i.each,d=>{}),{fill:u,stroke:f}=c;return(d,p,b,m)=>fo(d,p,(g,x,_,y,T,M,v,S,C,P,L)=>{let O=g.pxRound,z=t,U=n*Ct,G=a*Ct,q=l*Ct,H,ae;y.ori==0?[H,ae]=r(d,p):[ae,H]=r(d,p);let Y=y.dir*(y.ori==0?1:-1),ee=y.ori==0?Uf:eg,te=y.ori==0?h:(Pe,je,lt,Ee,zt,Ve,$e)=>{h(Pe,je,lt,zt,Ee,$e,Ve)},de=Et(d.bands,$m).find(Pe=>Pe.series[0]==p),ce=de!=null?de.dir:0,K=g.fillTo(d,p,g.min,g.max,ce),ue=O(v(K,T,L,C)),ge,Me,xe,Ge=P,it=O(g.width*Ct),He=!1,ct=null,at=null,Ze=null,en=null;u!=null&&(it==0||f!=null)&&(He=!0,ct=u.values(d,p,b,m),at=new Map,new Set(ct).forEach(Pe=>{Pe!=null&&at.set(Pe,new Path2D)}),it>0&&(Ze=f.values(d,p,b,m),en=new Map,new Set(Ze).forEach(Pe=>{Pe!=null&&en.set(Pe,new Path2D)})));let{x0:Xt,size:bn}=c;if(Xt!=null&&bn!=null){z=1,x=Xt.values(d,p,b,m),Xt.unit==2&&(x=x.map(lt=>d.posToVal(S+lt*P,y.key,!0)));let Pe=bn.values(d,p,b,m);bn.unit==2?Me=Pe[0]*P:Me=M(Pe[0],y,P,S)-M(0,y,P,S),Ge=Sy(x,_,M,y,P,S,Ge),xe=Ge-Me+U}else Ge=Sy(x,_,M,y,P,S,Ge),xe=Ge*o+U,Me=Ge-xe;xe<1&&(xe=0),it>=Me/2&&(it=0),xe<5&&(O=Ly);let Ot=xe>0,Nn=Ge-xe-(Ot?it:0);Me=O(Um(Nn,q,G)),ge=(z==0?Me/2:z==Y?0:Me)-z*Y*((z==0?U/2:0)+(Ot?it/2:0));let wt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Tn=He?null:new Path2D,ln=null;if(de!=null)ln=d.data[de.series[1]];else{let{y0:Pe,y1:je}=c;Pe!=null&&je!=null&&(_=je.values(d,p,b,m),ln=Pe.values(d,p,b,m))}let xn=H*Me,B=ae*Me;for(let Pe=Y==1?b:m;Pe>=b&&Pe<=m;Pe+=Y){let je=_[Pe];if(je==null)continue;if(ln!=null){let X=ln[Pe]??0;if(je-X==0)continue;ue=v(X,T,L,C)}let lt=y.distr!=2||c!=null?x[Pe]:Pe,Ee=M(lt,y,P,S),zt=v(Et(je,K),T,L,C),Ve=O(Ee-ge),$e=O(xi(zt,ue)),D=O(fs(zt,ue)),E=$e-D;if(je!=null){let X=je<0?B:xn,fe=je<0?xn:B;He?(it>0&&Ze[Pe]!=null&&ee(en.get(Ze[Pe]),Ve,D+ki(it/2),Me,xi(0,E-it),X,fe),ct[Pe]!=null&&ee(at.get(ct[Pe]),Ve,D+ki(it/2),Me,xi(0,E-it),X,fe)):ee(Tn,Ve,D+ki(it/2),Me,xi(0,E-it),X,fe),te(d,p,Pe,Ve-it/2,D,Me+it,E)}}return it>0?wt.stroke=He?en:Tn:He||(wt._fill=g.width==0?g._fill:g._stroke??g._fill,wt.width=0),wt.fill=He?at:Tn,wt})}function DC(i,e){let t=Et(e?.alignGaps,0);return(n,s,r,o)=>fo(n,s,(a,l,c,h,u,f,d,p,b,m,g)=>{[r,o]=Rf(c,r,o);let x=a.pxRound,_=H=>x(f(H,h,m,p)),y=H=>x(d(H,u,g,b)),T,M,v;h.ori==0?(T=Df,v=Ta,M=r_):(T=Nf,v=Aa,M=o_);let S=h.dir*(h.ori==0?1:-1),C=_(l[S==1?r:o]),P=C,L=[],O=[];for(let H=S==1?r:o;H>=r&&H<=o;H+=S)if(c[H]!=null){let Y=l[H],ee=_(Y);L.push(P=ee),O.push(y(c[H]))}let z={stroke:i(L,O,T,v,M,x),fill:null,clip:null,band:null,gaps:null,flags:Ma},U=z.stroke,[G,q]=Km(n,s);if(a.fill!=null||G!=0){let H=z.fill=new Path2D(U),ae=a.fillTo(n,s,a.min,a.max,G),Y=y(ae);v(H,P,Y),v(H,C,Y)}if(!a.spanGaps){let H=[];H.push(...Qm(l,c,r,o,S,_,t)),z.gaps=H=a.gaps(n,s,r,o,H),z.clip=Lf(H,h.ori,p,b,m,g)}return q!=0&&(z.band=q==2?[dr(n,s,r,o,U,-1),dr(n,s,r,o,U,1)]:dr(n,s,r,o,U,q)),z})}function NC(i){return DC(UC,i)}function UC(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=e[f+1]-e[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,e[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,e[f+1]-l[f+1]*u[f]/3,i[f+1],e[f+1])}return a}var Bm=new Set;function My(){for(let i of Bm)i.syncRect(!0)}Ea&&(ho(mR,ya,My),ho(gR,ya,My,!0),ho(Ef,ya,()=>{Gn.pxRatio=Ct}));var FC=c_(),OC=a_();function Ey(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>zm(r,o,e,t))}function kC(i,e){return i.map((t,n)=>n==0?{}:En({},e,t))}function zm(i,e,t,n){return En({},e==0?t:n,i)}function h_(i,e,t){return e==null?wa:[e,t]}var BC=h_;function zC(i,e,t){return e==null?wa:Tf(e,t,Xm,!0)}function u_(i,e,t,n){return e==null?wa:Cf(e,t,i.scales[n].log,!1)}var HC=u_;function f_(i,e,t,n){return e==null?wa:Wm(e,t,i.scales[n].log,!1)}var VC=f_;function GC(i,e,t,n,s){let r=xi(iy(i),iy(e)),o=e-i,a=us(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Or.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Ty(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Ln((t=+s)*Ct))+"px"),[i,e,t]}function WC(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Wt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Gn(i,e,t){let n={mode:Et(i.mode,1)},s=n.mode;function r(w,A,N,F){let W=A.valToPct(w);return F+N*(A.dir==-1?1-W:W)}function o(w,A,N,F){let W=A.valToPct(w);return F+N*(A.dir==-1?W:1-W)}function a(w,A,N,F){return A.ori==0?r(w,A,N,F):o(w,A,N,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=ji(J3);if(i.id!=null&&(c.id=i.id),Oi(c,i.class),i.title){let w=ji(eR,c);w.textContent=i.title}let h=hs("canvas"),u=n.ctx=h.getContext("2d"),f=ji(tR,c);ho("click",f,w=>{w.target===p&&(jt!=yo||tn!=_o)&&Wn.click(n,w)},!0);let d=n.under=ji(nR,f);f.appendChild(h);let p=n.over=ji(iR,f);i=Sa(i);let b=+Et(i.pxAlign,1),m=wy(b);(i.plugins||[]).forEach(w=>{w.opts&&(i=w.opts(n,i)||i)});let g=i.ms||.001,x=n.series=s==1?Ey(i.series||[],my,yy,!1):kC(i.series||[null],vy),_=n.axes=Ey(i.axes||[],py,by,!0),y=n.scales={},T=n.bands=i.bands||[];T.forEach(w=>{w.fill=_t(w.fill||null),w.dir=Et(w.dir,-1)});let M=s==2?x[1].facets[0].scale:x[0].scale,v={axes:ks,series:mt},S=(i.drawOrder||["axes","series"]).map(w=>v[w]);function C(w){let A=w.distr==3?N=>fr(N>0?N:w.clamp(n,N,w.min,w.max,w.key)):w.distr==4?N=>Am(N,w.asinh):w.distr==100?N=>w.fwd(N):N=>N;return N=>{let F=A(N),{_min:W,_max:J}=w,le=J-W;return(F-W)/le}}function P(w){let A=y[w];if(A==null){let N=(i.scales||oc)[w]||oc;if(N.from!=null){P(N.from);let F=En({},y[N.from],N,{key:w});F.valToPct=C(F),y[w]=F}else{A=y[w]=En({},w==M?e_:TC,N),A.key=w;let F=A.time,W=A.range,J=Fr(W);if((w!=M||s==2&&!F)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?ey:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?ey:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&If(W))){let le=W;W=(pe,_e,Ne)=>_e==null?wa:Tf(_e,Ne,le)}A.range=_t(W||(F?BC:w==M?A.distr==3?HC:A.distr==4?VC:h_:A.distr==3?u_:A.distr==4?f_:zC)),A.auto=_t(J?!1:A.auto),A.clamp=_t(A.clamp||EC),A._min=A._max=null,A.valToPct=C(A)}}}P("x"),P("y"),s==1&&x.forEach(w=>{P(w.scale)}),_.forEach(w=>{P(w.scale)});for(let w in i.scales)P(w);let L=y[M],O=L.distr,z,U;L.ori==0?(Oi(c,K3),z=r,U=o):(Oi(c,Q3),z=o,U=r);let G={};for(let w in y){let A=y[w];(A.min!=null||A.max!=null)&&(G[w]={min:A.min,max:A.max},A.min=A.max=null)}let q=i.tzDate||(w=>new Date(Ln(w/g))),H=i.fmtDate||Ym,ae=g==1?KR(q):tC(q),Y=uy(q,hy(g==1?JR:eC,H)),ee=dy(q,fy(iC,H)),te=[],de=n.legend=En({},oC,i.legend),ce=n.cursor=En({},fC,{drag:{y:s==2}},i.cursor),K=de.show,ue=ce.show,ge=de.markers;de.idxs=te,ge.width=_t(ge.width),ge.dash=_t(ge.dash),ge.stroke=_t(ge.stroke),ge.fill=_t(ge.fill);let Me,xe,Ge,it=[],He=[],ct,at=!1,Ze={};if(de.live){let w=x[1]?x[1].values:null;at=w!=null,ct=at?w(n,1,0):{_:0};for(let A in ct)Ze[A]=Vm}if(K)if(Me=hs("table",cR,c),Ge=hs("tbody",null,Me),de.mount(n,Me),at){xe=hs("thead",null,Me,Ge);let w=hs("tr",null,xe);hs("th",null,w);for(var en in ct)hs("th",Hv,w).textContent=en}else Oi(Me,uR),de.live&&Oi(Me,hR);let Xt={show:!0},bn={show:!1};function Ot(w,A){if(A==0&&(at||!de.live||s==2))return wa;let N=[],F=hs("tr",fR,Ge,Ge.childNodes[A]);Oi(F,w.class),w.show||Oi(F,co);let W=hs("th",null,F);if(ge.show){let pe=ji(dR,W);if(A>0){let _e=ge.width(n,A);_e&&(pe.style.border=_e+"px "+ge.dash(n,A)+" "+ge.stroke(n,A)),pe.style.background=ge.fill(n,A)}}let J=ji(Hv,W);w.label instanceof HTMLElement?J.appendChild(w.label):J.textContent=w.label,A>0&&(ge.show||(J.style.color=w.width>0?ge.stroke(n,A):ge.fill(n,A)),wt("click",W,pe=>{if(ce._lock)return;et(pe);let _e=x.indexOf(w);if((pe.ctrlKey||pe.metaKey)!=de.isolate){let Ne=x.some((Ue,Oe)=>Oe>0&&Oe!=_e&&Ue.show);x.forEach((Ue,Oe)=>{Oe>0&&gs(Oe,Ne?Oe==_e?Xt:bn:Xt,!0,wn.setSeries)})}else gs(_e,{show:!w.show},!0,wn.setSeries)},!1),tt&&wt(Xv,W,pe=>{ce._lock||(et(pe),gs(x.indexOf(w),So,!0,wn.setSeries))},!1));for(var le in ct){let pe=hs("td",pR,F);pe.textContent="--",N.push(pe)}return[F,N]}let Nn=new Map;function wt(w,A,N,F=!0){let W=Nn.get(A)||{},J=ce.bind[w](n,A,N,F);J&&(ho(w,A,W[w]=J),Nn.set(A,W))}function Tn(w,A,N){let F=Nn.get(A)||{};for(let W in F)(w==null||W==w)&&(Nm(W,A,F[W]),delete F[W]);w==null&&Nn.delete(A)}let ln=0,xn=0,B=0,Pe=0,je=0,lt=0,Ee=je,zt=lt,Ve=B,$e=Pe,D=0,E=0,X=0,fe=0;n.bbox={};let oe=!1,ve=!1,ye=!1,ne=!1,se=!1,me=!1;function k(w,A,N){(N||w!=n.width||A!=n.height)&&re(w,A),ft(!1),ye=!0,ve=!0,Kn()}function re(w,A){n.width=ln=B=w,n.height=xn=Pe=A,je=lt=0,Se(),We();let N=n.bbox;D=N.left=ao(je*Ct,.5),E=N.top=ao(lt*Ct,.5),X=N.width=ao(B*Ct,.5),fe=N.height=ao(Pe*Ct,.5)}let ie=3;function Te(){let w=!1,A=0;for(;!w;){A++;let N=bo(A),F=ms(A);w=A==ie||N&&F,w||(re(n.width,n.height),ve=!0)}}function be({width:w,height:A}){k(w,A)}n.setSize=be;function Se(){let w=!1,A=!1,N=!1,F=!1;_.forEach((W,J)=>{if(W.show&&W._show){let{side:le,_size:pe}=W,_e=le%2,Ne=W.label!=null?W.labelSize:0,Ue=pe+Ne;Ue>0&&(_e?(B-=Ue,le==3?(je+=Ue,F=!0):N=!0):(Pe-=Ue,le==0?(lt+=Ue,w=!0):A=!0))}}),ds[0]=w,ds[1]=N,ds[2]=A,ds[3]=F,B-=Ji[1]+Ji[3],je+=Ji[3],Pe-=Ji[2]+Ji[0],lt+=Ji[0]}function We(){let w=je+B,A=lt+Pe,N=je,F=lt;function W(J,le){switch(J){case 1:return w+=le,w-le;case 2:return A+=le,A-le;case 3:return N-=le,N+le;case 0:return F-=le,F+le}}_.forEach((J,le)=>{if(J.show&&J._show){let pe=J.side;J._pos=W(pe,J._size),J.label!=null&&(J._lpos=W(pe,J.labelSize))}})}if(ce.dataIdx==null){let w=ce.hover,A=w.skip=new Set(w.skip??[]);A.add(void 0);let N=w.prox=_t(w.prox),F=w.bias??=0;ce.dataIdx=(W,J,le,pe)=>{if(J==0)return le;let _e=le,Ne=N(W,J,le,pe)??Gt,Ue=Ne>=0&&Ne<Gt,Oe=L.ori==0?B:Pe,ot=ce.left,Tt=e[0],Mt=e[J];if(A.has(Mt[le])){_e=null;let bt=null,Je=null,qe;if(F==0||F==-1)for(qe=le;bt==null&&qe-- >0;)A.has(Mt[qe])||(bt=qe);if(F==0||F==1)for(qe=le;Je==null&&qe++<Mt.length;)A.has(Mt[qe])||(Je=qe);if(bt!=null||Je!=null)if(Ue){let Jt=bt==null?-1/0:z(Tt[bt],L,Oe,0),un=Je==null?1/0:z(Tt[Je],L,Oe,0),kn=ot-Jt,kt=un-ot;kn<=kt?kn<=Ne&&(_e=bt):kt<=Ne&&(_e=Je)}else _e=Je==null?bt:bt==null?Je:le-bt<=Je-le?bt:Je}else Ue&&Dn(ot-z(Tt[le],L,Oe,0))>Ne&&(_e=null);return _e}}let et=w=>{ce.event=w};ce.idxs=te,ce._lock=!1;let he=ce.points;he.show=_t(he.show),he.size=_t(he.size),he.stroke=_t(he.stroke),he.width=_t(he.width),he.fill=_t(he.fill);let ke=n.focus=En({},i.focus||{alpha:.3},ce.focus),tt=ke.prox>=0,Ce=tt&&he.one,ht=[],Yt=[],oi=[];function Ca(w,A){let N=he.show(n,A);if(N instanceof HTMLElement)return Oi(N,lR),Oi(N,w.class),Ns(N,-10,-10,B,Pe),p.insertBefore(N,ht[A]),N}function po(w,A){if(s==1||A>0){let N=s==1&&y[w.scale].time,F=w.value;w.value=N?oy(F)?dy(q,fy(F,H)):F||ee:F||wC,w.label=w.label||(N?pC:dC)}if(Ce||A>0){w.width=w.width==null?1:w.width,w.paths=w.paths||FC||TR,w.fillTo=_t(w.fillTo||AC),w.pxAlign=+Et(w.pxAlign,b),w.pxRound=wy(w.pxAlign),w.stroke=_t(w.stroke||null),w.fill=_t(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let N=SC(xi(1,w.width),1),F=w.points=En({},{size:N,width:xi(1,N*.2),stroke:w.stroke,space:N*2,paths:OC,_stroke:null,_fill:null},w.points);F.show=_t(F.show),F.filter=_t(F.filter),F.fill=_t(F.fill),F.stroke=_t(F.stroke),F.paths=_t(F.paths),F.pxAlign=w.pxAlign}if(K){let N=Ot(w,A);it.splice(A,0,N[0]),He.splice(A,0,N[1]),de.values.push(null)}if(ue){te.splice(A,0,null);let N=null;Ce?A==0&&(N=Ca(w,A)):A>0&&(N=Ca(w,A)),ht.splice(A,0,N),Yt.splice(A,0,0),oi.splice(A,0,0)}On("addSeries",A)}function qf(w,A){A=A??x.length,w=s==1?zm(w,A,my,yy):zm(w,A,{},vy),x.splice(A,0,w),po(x[A],A)}n.addSeries=qf;function cc(w){if(x.splice(w,1),K){de.values.splice(w,1),He.splice(w,1);let A=it.splice(w,1)[0];Tn(null,A.firstChild),A.remove()}ue&&(te.splice(w,1),ht.splice(w,1)[0].remove(),Yt.splice(w,1),oi.splice(w,1)),On("delSeries",w)}n.delSeries=cc;let ds=[!1,!1,!1,!1];function Us(w,A){if(w._show=w.show,w.show){let N=w.side%2,F=y[w.scale];F==null&&(w.scale=N?x[1].scale:M,F=y[w.scale]);let W=F.time;w.size=_t(w.size),w.space=_t(w.space),w.rotate=_t(w.rotate),Fr(w.incrs)&&w.incrs.forEach(le=>{!Or.has(le)&&Or.set(le,Uy(le))}),w.incrs=_t(w.incrs||(F.distr==2?YR:W?g==1?ZR:QR:lo)),w.splits=_t(w.splits||(W&&F.distr==1?ae:F.distr==3?Fm:F.distr==4?bC:gC)),w.stroke=_t(w.stroke),w.grid.stroke=_t(w.grid.stroke),w.ticks.stroke=_t(w.ticks.stroke),w.border.stroke=_t(w.border.stroke);let J=w.values;w.values=Fr(J)&&!Fr(J[0])?_t(J):W?Fr(J)?uy(q,hy(J,H)):oy(J)?nC(q,J):J||Y:J||mC,w.filter=_t(w.filter||(F.distr>=3&&F.log==10?yC:F.distr==3&&F.log==2?_C:Dy)),w.font=Ty(w.font),w.labelFont=Ty(w.labelFont),w._size=w.size(n,null,A,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(ds[A]=!0,w._el=ji(sR,f))}}function Fs(w,A,N,F){let[W,J,le,pe]=N,_e=A%2,Ne=0;return _e==0&&(pe||J)&&(Ne=A==0&&!W||A==2&&!le?Ln(py.size/3):0),_e==1&&(W||le)&&(Ne=A==1&&!J||A==3&&!pe?Ln(by.size/2):0),Ne}let Pa=n.padding=(i.padding||[Fs,Fs,Fs,Fs]).map(w=>_t(Et(w,Fs))),Ji=n._padding=Pa.map((w,A)=>w(n,A,ds,0)),cn,pn=null,mn=null,ps=s==1?x[0].idxs:null,Ti=null,pr=!1;function Ia(w,A){if(e=w??[],n.data=n._data=e,s==2){cn=0;for(let N=1;N<x.length;N++)cn+=e[N][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),Ti=e[0],cn=Ti.length;let N=e;if(O==2){N=e.slice();let F=N[0]=Array(cn);for(let W=0;W<cn;W++)F[W]=W}n._data=e=N}if(ft(!0),On("setData"),O==2&&(ye=!0),A!==!1){let N=L;N.auto(n,pr)?La():br(M,N.min,N.max),ne=ne||ce.left>=0,me=!0,Kn()}}n.setData=Ia;function La(){pr=!0;let w,A;s==1&&(cn>0?(pn=ps[0]=0,mn=ps[1]=cn-1,w=e[0][pn],A=e[0][mn],O==2?(w=pn,A=mn):w==A&&(O==3?[w,A]=Cf(w,w,L.log,!1):O==4?[w,A]=Wm(w,w,L.log,!1):L.time?A=w+Ln(86400/g):[w,A]=Tf(w,A,Xm,!0))):(pn=ps[0]=w=null,mn=ps[1]=A=null)),br(M,w,A)}let mo,mr,go,R,V,Q,$,j,Ae,Le;function Re(w,A,N,F,W,J){w??=Gv,N??=$m,F??="butt",W??=Gv,J??="round",w!=mo&&(u.strokeStyle=mo=w),W!=mr&&(u.fillStyle=mr=W),A!=go&&(u.lineWidth=go=A),J!=V&&(u.lineJoin=V=J),F!=Q&&(u.lineCap=Q=F),N!=R&&u.setLineDash(R=N)}function De(w,A,N,F){A!=mr&&(u.fillStyle=mr=A),w!=$&&(u.font=$=w),N!=j&&(u.textAlign=j=N),F!=Ae&&(u.textBaseline=Ae=F)}function ze(w,A,N,F,W=0){if(F.length>0&&w.auto(n,pr)&&(A==null||A.min==null)){let J=Et(pn,0),le=Et(mn,F.length-1),pe=N.min==null?yR(F,J,le,W,w.distr==3):[N.min,N.max];w.min=fs(w.min,N.min=pe[0]),w.max=xi(w.max,N.max=pe[1])}}let st={min:null,max:null};function pt(){for(let F in y){let W=y[F];G[F]==null&&(W.min==null||G[M]!=null&&W.auto(n,pr))&&(G[F]=st)}for(let F in y){let W=y[F];G[F]==null&&W.from!=null&&G[W.from]!=null&&(G[F]=st)}G[M]!=null&&ft(!0);let w={};for(let F in G){let W=G[F];if(W!=null){let J=w[F]=Sa(y[F],CR);if(W.min!=null)En(J,W);else if(F!=M||s==2)if(cn==0&&J.from==null){let le=J.range(n,null,null,F);J.min=le[0],J.max=le[1]}else J.min=Gt,J.max=-Gt}}if(cn>0){x.forEach((F,W)=>{if(s==1){let J=F.scale,le=G[J];if(le==null)return;let pe=w[J];if(W==0){let _e=pe.range(n,pe.min,pe.max,J);pe.min=_e[0],pe.max=_e[1],pn=us(pe.min,e[0]),mn=us(pe.max,e[0]),mn-pn>1&&(e[0][pn]<pe.min&&pn++,e[0][mn]>pe.max&&mn--),F.min=Ti[pn],F.max=Ti[mn]}else F.show&&F.auto&&ze(pe,le,F,e[W],F.sorted);F.idxs[0]=pn,F.idxs[1]=mn}else if(W>0&&F.show&&F.auto){let[J,le]=F.facets,pe=J.scale,_e=le.scale,[Ne,Ue]=e[W],Oe=w[pe],ot=w[_e];Oe!=null&&ze(Oe,G[pe],J,Ne,J.sorted),ot!=null&&ze(ot,G[_e],le,Ue,le.sorted),F.min=le.min,F.max=le.max}});for(let F in w){let W=w[F],J=G[F];if(W.from==null&&(J==null||J.min==null)){let le=W.range(n,W.min==Gt?null:W.min,W.max==-Gt?null:W.max,F);W.min=le[0],W.max=le[1]}}}for(let F in w){let W=w[F];if(W.from!=null){let J=w[W.from];if(J.min==null)W.min=W.max=null;else{let le=W.range(n,J.min,J.max,F);W.min=le[0],W.max=le[1]}}}let A={},N=!1;for(let F in w){let W=w[F],J=y[F];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let le=J.distr;J._min=le==3?fr(J.min):le==4?Am(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?fr(J.max):le==4?Am(J.max,J.asinh):le==100?J.fwd(J.max):J.max,A[F]=N=!0}}if(N){x.forEach((F,W)=>{s==2?W>0&&A.y&&(F._paths=null):A[F.scale]&&(F._paths=null)});for(let F in A)ye=!0,On("setScale",F);ue&&ce.left>=0&&(ne=me=!0)}for(let F in G)G[F]=null}function Be(w){let A=Um(pn-1,0,cn-1),N=Um(mn+1,0,cn-1);for(;w[A]==null&&A>0;)A--;for(;w[N]==null&&N<cn-1;)N++;return[A,N]}function mt(){if(cn>0){let w=x.some(A=>A._focus)&&Le!=ke.alpha;w&&(u.globalAlpha=Le=ke.alpha),x.forEach((A,N)=>{if(N>0&&A.show&&(rn(N,!1),rn(N,!0),A._paths==null)){let F=Le;Le!=A.alpha&&(u.globalAlpha=Le=A.alpha);let W=s==2?[0,e[N][0].length-1]:Be(e[N]);A._paths=A.paths(n,N,W[0],W[1]),Le!=F&&(u.globalAlpha=Le=F)}}),x.forEach((A,N)=>{if(N>0&&A.show){let F=Le;Le!=A.alpha&&(u.globalAlpha=Le=A.alpha),A._paths!=null&&Nt(N,!1);{let W=A._paths!=null?A._paths.gaps:null,J=A.points.show(n,N,pn,mn,W),le=A.points.filter(n,N,J,W);(J||le)&&(A.points._paths=A.points.paths(n,N,pn,mn,le),Nt(N,!0))}Le!=F&&(u.globalAlpha=Le=F),On("drawSeries",N)}}),w&&(u.globalAlpha=Le=1)}}function rn(w,A){let N=A?x[w].points:x[w];N._stroke=N.stroke(n,w),N._fill=N.fill(n,w)}function Nt(w,A){let N=A?x[w].points:x[w],{stroke:F,fill:W,clip:J,flags:le,_stroke:pe=N._stroke,_fill:_e=N._fill,_width:Ne=N.width}=N._paths;Ne=Wt(Ne*Ct,3);let Ue=null,Oe=Ne%2/2;A&&_e==null&&(_e=Ne>0?"#fff":pe);let ot=N.pxAlign==1&&Oe>0;if(ot&&u.translate(Oe,Oe),!A){let Tt=D-Ne/2,Mt=E-Ne/2,bt=X+Ne,Je=fe+Ne;Ue=new Path2D,Ue.rect(Tt,Mt,bt,Je)}A?Fe(pe,Ne,N.dash,N.cap,_e,F,W,le,J):Ut(w,pe,Ne,N.dash,N.cap,_e,F,W,le,Ue,J),ot&&u.translate(-Oe,-Oe)}function Ut(w,A,N,F,W,J,le,pe,_e,Ne,Ue){let Oe=!1;_e!=0&&T.forEach((ot,Tt)=>{if(ot.series[0]==w){let Mt=x[ot.series[1]],bt=e[ot.series[1]],Je=(Mt._paths||oc).band;Fr(Je)&&(Je=ot.dir==1?Je[0]:Je[1]);let qe,Jt=null;Mt.show&&Je&&wR(bt,pn,mn)?(Jt=ot.fill(n,Tt)||J,qe=Mt._paths.clip):Je=null,Fe(A,N,F,W,Jt,le,pe,_e,Ne,Ue,qe,Je),Oe=!0}}),Oe||Fe(A,N,F,W,J,le,pe,_e,Ne,Ue)}let An=Ma|km;function Fe(w,A,N,F,W,J,le,pe,_e,Ne,Ue,Oe){Re(w,A,N,F,W),(_e||Ne||Oe)&&(u.save(),_e&&u.clip(_e),Ne&&u.clip(Ne)),Oe?(pe&An)==An?(u.clip(Oe),Ue&&u.clip(Ue),vt(W,le),vn(w,J,A)):pe&km?(vt(W,le),u.clip(Oe),vn(w,J,A)):pe&Ma&&(u.save(),u.clip(Oe),Ue&&u.clip(Ue),vt(W,le),u.restore(),vn(w,J,A)):(vt(W,le),vn(w,J,A)),(_e||Ne||Oe)&&u.restore()}function vn(w,A,N){N>0&&(A instanceof Map?A.forEach((F,W)=>{u.strokeStyle=mo=W,u.stroke(F)}):A!=null&&w&&u.stroke(A))}function vt(w,A){A instanceof Map?A.forEach((N,F)=>{u.fillStyle=mr=F,u.fill(N)}):A!=null&&w&&u.fill(A)}function Os(w,A,N,F){let W=_[w],J;if(F<=0)J=[0,0];else{let le=W._space=W.space(n,w,A,N,F),pe=W._incrs=W.incrs(n,w,A,N,F,le);J=GC(A,N,pe,F,le)}return W._found=J}function yn(w,A,N,F,W,J,le,pe,_e,Ne){let Ue=le%2/2;b==1&&u.translate(Ue,Ue),Re(pe,le,_e,Ne,pe),u.beginPath();let Oe,ot,Tt,Mt,bt=W+(F==0||F==3?-J:J);N==0?(ot=W,Mt=bt):(Oe=W,Tt=bt);for(let Je=0;Je<w.length;Je++)A[Je]!=null&&(N==0?Oe=Tt=w[Je]:ot=Mt=w[Je],u.moveTo(Oe,ot),u.lineTo(Tt,Mt));u.stroke(),b==1&&u.translate(-Ue,-Ue)}function bo(w){let A=!0;return _.forEach((N,F)=>{if(!N.show)return;let W=y[N.scale];if(W.min==null){N._show&&(A=!1,N._show=!1,ft(!1));return}else N._show||(A=!1,N._show=!0,ft(!1));let J=N.side,le=J%2,{min:pe,max:_e}=W,[Ne,Ue]=Os(F,pe,_e,le==0?B:Pe);if(Ue==0)return;let Oe=W.distr==2,ot=N._splits=N.splits(n,F,pe,_e,Ne,Ue,Oe),Tt=W.distr==2?ot.map(qe=>Ti[qe]):ot,Mt=W.distr==2?Ti[ot[1]]-Ti[ot[0]]:Ne,bt=N._values=N.values(n,N.filter(n,Tt,F,Ue,Mt),F,Ue,Mt);N._rotate=J==2?N.rotate(n,bt,F,Ue):0;let Je=N._size;N._size=Zi(N.size(n,bt,F,w)),Je!=null&&N._size!=Je&&(A=!1)}),A}function ms(w){let A=!0;return Pa.forEach((N,F)=>{let W=N(n,F,ds,w);W!=Ji[F]&&(A=!1),Ji[F]=W}),A}function ks(){for(let w=0;w<_.length;w++){let A=_[w];if(!A.show||!A._show)continue;let N=A.side,F=N%2,W,J,le=A.stroke(n,w),pe=N==0||N==3?-1:1,[_e,Ne]=A._found;if(A.label!=null){let ci=A.labelGap*pe,Ci=Ln((A._lpos+ci)*Ct);De(A.labelFont[0],le,"center",N==2?"top":Vv),u.save(),F==1?(W=J=0,u.translate(Ci,Ln(E+fe/2)),u.rotate((N==3?-Mf:Mf)/2)):(W=Ln(D+X/2),J=Ci);let Hr=Iy(A.label)?A.label(n,w,_e,Ne):A.label;u.fillText(Hr,W,J),u.restore()}if(Ne==0)continue;let Ue=y[A.scale],Oe=F==0?X:fe,ot=F==0?D:E,Tt=A._splits,Mt=Ue.distr==2?Tt.map(ci=>Ti[ci]):Tt,bt=Ue.distr==2?Ti[Tt[1]]-Ti[Tt[0]]:_e,Je=A.ticks,qe=A.border,Jt=Je.show?Je.size:0,un=Ln(Jt*Ct),kn=Ln((A.alignTo==2?A._size-Jt-A.gap:A.gap)*Ct),kt=A._rotate*-Mf/180,fn=m(A._pos*Ct),Ai=(un+kn)*pe,li=fn+Ai;J=F==0?li:0,W=F==1?li:0;let zi=A.font[0],Ki=A.align==1?xa:A.align==2?Mm:kt>0?xa:kt<0?Mm:F==0?"center":N==3?Mm:xa,xs=kt||F==1?"middle":N==2?"top":Vv;De(zi,le,Ki,xs);let Ri=A.font[1]*A.lineGap,Hi=Tt.map(ci=>m(a(ci,Ue,Oe,ot))),Qi=A._values;for(let ci=0;ci<Qi.length;ci++){let Ci=Qi[ci];if(Ci!=null){F==0?W=Hi[ci]:J=Hi[ci],Ci=""+Ci;let Hr=Ci.indexOf(`
`)==-1?[Ci]:Ci.split(/\n/gm);for(let hi=0;hi<Hr.length;hi++){let Mg=Hr[hi];kt?(u.save(),u.translate(W,J+hi*Ri),u.rotate(kt),u.fillText(Mg,0,0),u.restore()):u.fillText(Mg,W,J+hi*Ri)}}}Je.show&&yn(Hi,Je.filter(n,Mt,w,Ne,bt),F,N,fn,un,Wt(Je.width*Ct,3),Je.stroke(n,w),Je.dash,Je.cap);let vs=A.grid;vs.show&&yn(Hi,vs.filter(n,Mt,w,Ne,bt),F,F==0?2:1,F==0?E:D,F==0?fe:X,Wt(vs.width*Ct,3),vs.stroke(n,w),vs.dash,vs.cap),qe.show&&yn([fn],[1],F==0?1:0,F==0?1:2,F==1?E:D,F==1?fe:X,Wt(qe.width*Ct,3),qe.stroke(n,w),qe.dash,qe.cap)}On("drawAxes")}function ft(w){x.forEach((A,N)=>{N>0&&(A._paths=null,w&&(s==1?(A.min=null,A.max=null):A.facets.forEach(F=>{F.min=null,F.max=null})))})}let hn=!1,ai=!1,Ft=[];function _n(){ai=!1;for(let w=0;w<Ft.length;w++)On(...Ft[w]);Ft.length=0}function Kn(){hn||(FR(og),hn=!0)}function hc(w,A=!1){hn=!0,ai=A,w(n),og(),A&&Ft.length>0&&queueMicrotask(_n)}n.batch=hc;function og(){if(oe&&(pt(),oe=!1),ye&&(Te(),ye=!1),ve){if(Qt(d,xa,je),Qt(d,"top",lt),Qt(d,nc,B),Qt(d,ic,Pe),Qt(p,xa,je),Qt(p,"top",lt),Qt(p,nc,B),Qt(p,ic,Pe),Qt(f,nc,ln),Qt(f,ic,xn),h.width=Ln(ln*Ct),h.height=Ln(xn*Ct),_.forEach(({_el:w,_show:A,_size:N,_pos:F,side:W})=>{if(w!=null)if(A){let J=W===3||W===0?N:0,le=W%2==1;Qt(w,le?"left":"top",F-J),Qt(w,le?"width":"height",N),Qt(w,le?"top":"left",le?lt:je),Qt(w,le?"height":"width",le?Pe:B),Dm(w,co)}else Oi(w,co)}),mo=mr=go=V=Q=$=j=Ae=R=null,Le=1,Ua(!0),je!=Ee||lt!=zt||B!=Ve||Pe!=$e){ft(!1);let w=B/Ve,A=Pe/$e;if(ue&&!ne&&ce.left>=0){ce.left*=w,ce.top*=A,xo&&Ns(xo,Ln(ce.left),0,B,Pe),vo&&Ns(vo,0,Ln(ce.top),B,Pe);for(let N=0;N<ht.length;N++){let F=ht[N];F!=null&&(Yt[N]*=w,oi[N]*=A,Ns(F,Zi(Yt[N]),Zi(oi[N]),B,Pe))}}if(Zt.show&&!se&&Zt.left>=0&&Zt.width>0){Zt.left*=w,Zt.width*=w,Zt.top*=A,Zt.height*=A;for(let N in Kf)Qt(wo,N,Zt[N])}Ee=je,zt=lt,Ve=B,$e=Pe}On("setSize"),ve=!1}ln>0&&xn>0&&(u.clearRect(0,0,h.width,h.height),On("drawClear"),S.forEach(w=>w()),On("draw")),Zt.show&&se&&(uc(Zt),se=!1),ue&&ne&&(zr(null,!0,!1),ne=!1),de.show&&de.live&&me&&(Zf(),me=!1),l||(l=!0,n.status=1,On("ready")),pr=!1,hn=!1}n.redraw=(w,A)=>{ye=A||!1,w!==!1?br(M,L.min,L.max):Kn()};function $f(w,A){let N=y[w];if(N.from==null){if(cn==0){let F=N.range(n,A.min,A.max,w);A.min=F[0],A.max=F[1]}if(A.min>A.max){let F=A.min;A.min=A.max,A.max=F}if(cn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;w==M&&N.distr==2&&cn>0&&(A.min=us(A.min,e[0]),A.max=us(A.max,e[0]),A.min==A.max&&A.max++),G[w]=A,oe=!0,Kn()}}n.setScale=$f;let Yf,jf,xo,vo,ag,lg,yo,_o,cg,hg,jt,tn,gr=!1,Wn=ce.drag,Un=Wn.x,Fn=Wn.y;ue&&(ce.x&&(Yf=ji(oR,p)),ce.y&&(jf=ji(aR,p)),L.ori==0?(xo=Yf,vo=jf):(xo=jf,vo=Yf),jt=ce.left,tn=ce.top);let Zt=n.select=En({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),wo=Zt.show?ji(rR,Zt.over?p:d):null;function uc(w,A){if(Zt.show){for(let N in w)Zt[N]=w[N],N in Kf&&Qt(wo,N,w[N]);A!==!1&&On("setSelect")}}n.setSelect=uc;function w_(w){if(x[w].show)K&&Dm(it[w],co);else if(K&&Oi(it[w],co),ue){let N=Ce?ht[0]:ht[w];N!=null&&Ns(N,-10,-10,B,Pe)}}function br(w,A,N){$f(w,{min:A,max:N})}function gs(w,A,N,F){A.focus!=null&&A_(w),A.show!=null&&x.forEach((W,J)=>{J>0&&(w==J||w==null)&&(W.show=A.show,w_(J),s==2?(br(W.facets[0].scale,null,null),br(W.facets[1].scale,null,null)):br(W.scale,null,null),Kn())}),N!==!1&&On("setSeries",w,A),F&&Fa("setSeries",n,w,A)}n.setSeries=gs;function S_(w,A){En(T[w],A)}function M_(w,A){w.fill=_t(w.fill||null),w.dir=Et(w.dir,-1),A=A??T.length,T.splice(A,0,w)}function E_(w){w==null?T.length=0:T.splice(w,1)}n.addBand=M_,n.setBand=S_,n.delBand=E_;function T_(w,A){x[w].alpha=A,ue&&ht[w]!=null&&(ht[w].style.opacity=A),K&&it[w]&&(it[w].style.opacity=A)}let Bs,xr,Br,So={focus:!0};function A_(w){if(w!=Br){let A=w==null,N=ke.alpha!=1;x.forEach((F,W)=>{if(s==1||W>0){let J=A||W==0||W==w;F._focus=A?null:J,N&&T_(W,J?1:ke.alpha)}}),Br=w,N&&Kn()}}K&&tt&&wt(qv,Me,w=>{ce._lock||(et(w),Br!=null&&gs(null,So,!0,wn.setSeries))});function bs(w,A,N){let F=y[A];N&&(w=w/Ct-(F.ori==1?lt:je));let W=B;F.ori==1&&(W=Pe,w=W-w),F.dir==-1&&(w=W-w);let J=F._min,le=F._max,pe=w/W,_e=J+(le-J)*pe,Ne=F.distr;return Ne==3?_a(10,_e):Ne==4?MR(_e,F.asinh):Ne==100?F.bwd(_e):_e}function R_(w,A){let N=bs(w,M,A);return us(N,e[0],pn,mn)}n.valToIdx=w=>us(w,e[0]),n.posToIdx=R_,n.posToVal=bs,n.valToPos=(w,A,N)=>y[A].ori==0?r(w,y[A],N?X:B,N?D:0):o(w,y[A],N?fe:Pe,N?E:0),n.setCursor=(w,A,N)=>{jt=w.left,tn=w.top,zr(null,A,N)};function ug(w,A){Qt(wo,xa,Zt.left=w),Qt(wo,nc,Zt.width=A)}function fg(w,A){Qt(wo,"top",Zt.top=w),Qt(wo,ic,Zt.height=A)}let Da=L.ori==0?ug:fg,Na=L.ori==1?ug:fg;function C_(){if(K&&de.live)for(let w=s==2?1:0;w<x.length;w++){if(w==0&&at)continue;let A=de.values[w],N=0;for(let F in A)He[w][N++].firstChild.nodeValue=A[F]}}function Zf(w,A){if(w!=null&&(w.idxs?w.idxs.forEach((N,F)=>{te[F]=N}):RR(w.idx)||te.fill(w.idx),de.idx=te[0]),K&&de.live){for(let N=0;N<x.length;N++)(N>0||s==1&&!at)&&P_(N,te[N]);C_()}me=!1,A!==!1&&On("setLegend")}n.setLegend=Zf;function P_(w,A){let N=x[w],F=w==0&&O==2?Ti:e[w],W;at?W=N.values(n,w,A)??Ze:(W=N.value(n,A==null?null:F[A],w,A),W=W==null?Ze:{_:W}),de.values[w]=W}function zr(w,A,N){cg=jt,hg=tn,[jt,tn]=ce.move(n,jt,tn),ce.left=jt,ce.top=tn,ue&&(xo&&Ns(xo,Ln(jt),0,B,Pe),vo&&Ns(vo,0,Ln(tn),B,Pe));let F,W=pn>mn;Bs=Gt,xr=null;let J=L.ori==0?B:Pe,le=L.ori==1?B:Pe;if(jt<0||cn==0||W){F=ce.idx=null;for(let pe=0;pe<x.length;pe++){let _e=ht[pe];_e!=null&&Ns(_e,-10,-10,B,Pe)}tt&&gs(null,So,!0,w==null&&wn.setSeries),de.live&&(te.fill(F),me=!0)}else{let pe,_e,Ne;s==1&&(pe=L.ori==0?jt:tn,_e=bs(pe,M),F=ce.idx=us(_e,e[0],pn,mn),Ne=z(e[0][F],L,J,0));let Ue=-10,Oe=-10,ot=0,Tt=0,Mt=!0,bt="",Je="";for(let qe=s==2?1:0;qe<x.length;qe++){let Jt=x[qe],un=te[qe],kn=un==null?null:s==1?e[qe][un]:e[qe][1][un],kt=ce.dataIdx(n,qe,F,_e),fn=kt==null?null:s==1?e[qe][kt]:e[qe][1][kt];if(me=me||fn!=kn||kt!=un,te[qe]=kt,qe>0&&Jt.show){let Ai=kt==null?-10:kt==F?Ne:z(s==1?e[0][kt]:e[qe][0][kt],L,J,0),li=fn==null?-10:U(fn,s==1?y[Jt.scale]:y[Jt.facets[1].scale],le,0);if(tt&&fn!=null){let zi=L.ori==1?jt:tn,Ki=Dn(ke.dist(n,qe,kt,li,zi));if(Ki<Bs){let xs=ke.bias;if(xs!=0){let Ri=bs(zi,Jt.scale),Hi=fn>=0?1:-1,Qi=Ri>=0?1:-1;Qi==Hi&&(Qi==1?xs==1?fn>=Ri:fn<=Ri:xs==1?fn<=Ri:fn>=Ri)&&(Bs=Ki,xr=qe)}else Bs=Ki,xr=qe}}if(me||Ce){let zi,Ki;L.ori==0?(zi=Ai,Ki=li):(zi=li,Ki=Ai);let xs,Ri,Hi,Qi,vs,ci,Ci=!0,Hr=he.bbox;if(Hr!=null){Ci=!1;let hi=Hr(n,qe);Hi=hi.left,Qi=hi.top,xs=hi.width,Ri=hi.height}else Hi=zi,Qi=Ki,xs=Ri=he.size(n,qe);if(ci=he.fill(n,qe),vs=he.stroke(n,qe),Ce)qe==xr&&Bs<=ke.prox&&(Ue=Hi,Oe=Qi,ot=xs,Tt=Ri,Mt=Ci,bt=ci,Je=vs);else{let hi=ht[qe];hi!=null&&(Yt[qe]=Hi,oi[qe]=Qi,Qv(hi,xs,Ri,Ci),Jv(hi,ci,vs),Ns(hi,Zi(Hi),Zi(Qi),B,Pe))}}}}if(Ce){let qe=ke.prox,Jt=Br==null?Bs<=qe:Bs>qe||xr!=Br;if(me||Jt){let un=ht[0];un!=null&&(Yt[0]=Ue,oi[0]=Oe,Qv(un,ot,Tt,Mt),Jv(un,bt,Je),Ns(un,Zi(Ue),Zi(Oe),B,Pe))}}}if(Zt.show&&gr)if(w!=null){let[pe,_e]=wn.scales,[Ne,Ue]=wn.match,[Oe,ot]=w.cursor.sync.scales,Tt=w.cursor.drag;if(Un=Tt._x,Fn=Tt._y,Un||Fn){let{left:Mt,top:bt,width:Je,height:qe}=w.select,Jt=w.scales[Oe].ori,un=w.posToVal,kn,kt,fn,Ai,li,zi=pe!=null&&Ne(pe,Oe),Ki=_e!=null&&Ue(_e,ot);zi&&Un?(Jt==0?(kn=Mt,kt=Je):(kn=bt,kt=qe),fn=y[pe],Ai=z(un(kn,Oe),fn,J,0),li=z(un(kn+kt,Oe),fn,J,0),Da(fs(Ai,li),Dn(li-Ai))):Da(0,J),Ki&&Fn?(Jt==1?(kn=Mt,kt=Je):(kn=bt,kt=qe),fn=y[_e],Ai=U(un(kn,ot),fn,le,0),li=U(un(kn+kt,ot),fn,le,0),Na(fs(Ai,li),Dn(li-Ai))):Na(0,le)}else Qf()}else{let pe=Dn(cg-ag),_e=Dn(hg-lg);if(L.ori==1){let ot=pe;pe=_e,_e=ot}Un=Wn.x&&pe>=Wn.dist,Fn=Wn.y&&_e>=Wn.dist;let Ne=Wn.uni;Ne!=null?Un&&Fn&&(Un=pe>=Ne,Fn=_e>=Ne,!Un&&!Fn&&(_e>pe?Fn=!0:Un=!0)):Wn.x&&Wn.y&&(Un||Fn)&&(Un=Fn=!0);let Ue,Oe;Un&&(L.ori==0?(Ue=yo,Oe=jt):(Ue=_o,Oe=tn),Da(fs(Ue,Oe),Dn(Oe-Ue)),Fn||Na(0,le)),Fn&&(L.ori==1?(Ue=yo,Oe=jt):(Ue=_o,Oe=tn),Na(fs(Ue,Oe),Dn(Oe-Ue)),Un||Da(0,J)),!Un&&!Fn&&(Da(0,0),Na(0,0))}if(Wn._x=Un,Wn._y=Fn,w==null){if(N){if(Sg!=null){let[pe,_e]=wn.scales;wn.values[0]=pe!=null?bs(L.ori==0?jt:tn,pe):null,wn.values[1]=_e!=null?bs(L.ori==1?jt:tn,_e):null}Fa(Em,n,jt,tn,B,Pe,F)}if(tt){let pe=N&&wn.setSeries,_e=ke.prox;Br==null?Bs<=_e&&gs(xr,So,!0,pe):Bs>_e?gs(null,So,!0,pe):xr!=Br&&gs(xr,So,!0,pe)}}me&&(de.idx=F,Zf()),A!==!1&&On("setCursor")}let vr=null;Object.defineProperty(n,"rect",{get(){return vr==null&&Ua(!1),vr}});function Ua(w=!1){w?vr=null:(vr=p.getBoundingClientRect(),On("syncRect",vr))}function dg(w,A,N,F,W,J,le){ce._lock||gr&&w!=null&&w.movementX==0&&w.movementY==0||(Jf(w,A,N,F,W,J,le,!1,w!=null),w!=null?zr(null,!0,!0):zr(A,!0,!1))}function Jf(w,A,N,F,W,J,le,pe,_e){if(vr==null&&Ua(!1),et(w),w!=null)N=w.clientX-vr.left,F=w.clientY-vr.top;else{if(N<0||F<0){jt=-10,tn=-10;return}let[Ne,Ue]=wn.scales,Oe=A.cursor.sync,[ot,Tt]=Oe.values,[Mt,bt]=Oe.scales,[Je,qe]=wn.match,Jt=A.axes[0].side%2==1,un=L.ori==0?B:Pe,kn=L.ori==1?B:Pe,kt=Jt?J:W,fn=Jt?W:J,Ai=Jt?F:N,li=Jt?N:F;if(Mt!=null?N=Je(Ne,Mt)?a(ot,y[Ne],un,0):-10:N=un*(Ai/kt),bt!=null?F=qe(Ue,bt)?a(Tt,y[Ue],kn,0):-10:F=kn*(li/fn),L.ori==1){let zi=N;N=F,F=zi}}_e&&(A==null||A.cursor.event.type==Em)&&((N<=1||N>=B-1)&&(N=ao(N,B)),(F<=1||F>=Pe-1)&&(F=ao(F,Pe))),pe?(ag=N,lg=F,[yo,_o]=ce.move(n,N,F)):(jt=N,tn=F)}let Kf={width:0,height:0,left:0,top:0};function Qf(){uc(Kf,!1)}let pg,mg,gg,bg;function xg(w,A,N,F,W,J,le){gr=!0,Un=Fn=Wn._x=Wn._y=!1,Jf(w,A,N,F,W,J,le,!0,!1),w!=null&&(wt(Tm,Im,vg,!1),Fa(Wv,n,yo,_o,B,Pe,null));let{left:pe,top:_e,width:Ne,height:Ue}=Zt;pg=pe,mg=_e,gg=Ne,bg=Ue}function vg(w,A,N,F,W,J,le){gr=Wn._x=Wn._y=!1,Jf(w,A,N,F,W,J,le,!1,!0);let{left:pe,top:_e,width:Ne,height:Ue}=Zt,Oe=Ne>0||Ue>0,ot=pg!=pe||mg!=_e||gg!=Ne||bg!=Ue;if(Oe&&ot&&uc(Zt),Wn.setScale&&Oe&&ot){let Tt=pe,Mt=Ne,bt=_e,Je=Ue;if(L.ori==1&&(Tt=_e,Mt=Ue,bt=pe,Je=Ne),Un&&br(M,bs(Tt,M),bs(Tt+Mt,M)),Fn)for(let qe in y){let Jt=y[qe];qe!=M&&Jt.from==null&&Jt.min!=Gt&&br(qe,bs(bt+Je,qe),bs(bt,qe))}Qf()}else ce.lock&&(ce._lock=!ce._lock,zr(A,!0,w!=null));w!=null&&(Tn(Tm,Im),Fa(Tm,n,jt,tn,B,Pe,null))}function I_(w,A,N,F,W,J,le){if(ce._lock)return;et(w);let pe=gr;if(gr){let _e=!0,Ne=!0,Ue=10,Oe,ot;L.ori==0?(Oe=Un,ot=Fn):(Oe=Fn,ot=Un),Oe&&ot&&(_e=jt<=Ue||jt>=B-Ue,Ne=tn<=Ue||tn>=Pe-Ue),Oe&&_e&&(jt=jt<yo?0:B),ot&&Ne&&(tn=tn<_o?0:Pe),zr(null,!0,!0),gr=!1}jt=-10,tn=-10,te.fill(null),zr(null,!0,!0),pe&&(gr=pe)}function yg(w,A,N,F,W,J,le){ce._lock||(et(w),La(),Qf(),w!=null&&Fa($v,n,jt,tn,B,Pe,null))}function _g(){_.forEach(WC),k(n.width,n.height,!0)}ho(Ef,ya,_g);let Mo={};Mo.mousedown=xg,Mo.mousemove=dg,Mo.mouseup=vg,Mo.dblclick=yg,Mo.setSeries=(w,A,N,F)=>{let W=wn.match[2];N=W(n,A,N),N!=-1&&gs(N,F,!0,!1)},ue&&(wt(Wv,p,xg),wt(Em,p,dg),wt(Xv,p,w=>{et(w),Ua(!1)}),wt(qv,p,I_),wt($v,p,yg),Bm.add(n),n.syncRect=Ua);let fc=n.hooks=i.hooks||{};function On(w,A,N){ai?Ft.push([w,A,N]):w in fc&&fc[w].forEach(F=>{F.call(null,n,A,N)})}(i.plugins||[]).forEach(w=>{for(let A in w.hooks)fc[A]=(fc[A]||[]).concat(w.hooks[A])});let wg=(w,A,N)=>N,wn=En({key:null,setSeries:!1,filters:{pub:sy,sub:sy},scales:[M,x[1]?x[1].scale:null],match:[ry,ry,wg],values:[null,null]},ce.sync);wn.match.length==2&&wn.match.push(wg),ce.sync=wn;let Sg=wn.key,ed=t_(Sg);function Fa(w,A,N,F,W,J,le){wn.filters.pub(w,A,N,F,W,J,le)&&ed.pub(w,A,N,F,W,J,le)}ed.sub(n);function L_(w,A,N,F,W,J,le){wn.filters.sub(w,A,N,F,W,J,le)&&Mo[w](null,A,N,F,W,J,le)}n.pub=L_;function D_(){ed.unsub(n),Bm.delete(n),Nn.clear(),Nm(Ef,ya,_g),c.remove(),Me?.remove(),On("destroy")}n.destroy=D_;function td(){On("init",i,e),Ia(e||i.data,!1),G[M]?$f(M,G[M]):La(),se=Zt.show&&(Zt.width>0||Zt.height>0),ne=me=!0,k(i.width,i.height)}return x.forEach(po),_.forEach(Us),t?t instanceof HTMLElement?(t.appendChild(c),td()):t(n,td):td(),n}Gn.assign=En;Gn.fmtNum=qm;Gn.rangeNum=Tf;Gn.rangeLog=Cf;Gn.rangeAsinh=Wm;Gn.orient=fo;Gn.pxRatio=Ct;Gn.join=UR;Gn.fmtDate=Ym,Gn.tzDate=qR;Gn.sync=t_;{Gn.addGap=RC,Gn.clipGaps=Lf;let i=Gn.paths={points:a_};i.linear=c_,i.stepped=IC,i.bars=LC,i.spline=NC}var Ff=["#2f7ed8","#e4572e","#2a9d5c","#9a5fc9","#d99a1c","#17a2b0","#c2448d","#7a7f87"],Of=class{constructor(e,t,n){this.runs=e;this.seek=t;this.lines=n;this.object=Z("section.plots",{"aria-label":"histories"},Z("div.plothead",{},this.bar,this.extra),this.body),new ResizeObserver(()=>this.resize()).observe(this.body),this.tabs()}runs;seek;lines;object;tab="histories";now=null;body=Z("div.charts");bar=Z("div.tabs",{role:"tablist"});extra=Z("span.extra");plots=[];curves=[];blockField="displacement";picked=null;stamp=0;tabs(){let e=[["histories","Histories"],["energy","Energy"],["block","Block"],["line","Line"]];this.bar.replaceChildren(...e.map(([t,n])=>Z("button",{role:"tab",type:"button","aria-selected":String(t===this.tab),onclick:()=>{this.open(t)}},n)))}async open(e){this.tab=e,this.tabs();let t=++this.stamp;if(this.extra.replaceChildren(),e==="block")return this.openBlock(t);if(e==="line")return this.openLine();let n=await Promise.all(this.runs.map(r=>r.table(e).catch(()=>null)));if(t!==this.stamp)return;this.curves=n.flatMap((r,o)=>r?YC(r,o>0):[]);let s=e==="histories"?'This run recorded no histories. Request them in the scene: [[outputs]] history = { field = "..." }':"This run has no energy.csv.";this.draw(s)}setPicked(e,t){this.picked=t===null?null:{run:e,id:t},this.tab==="block"&&this.open("block")}async openBlock(e){if(this.curves=[],!this.picked)return this.draw("Pick a block in the picture to see its history.");let{run:t,id:n}=this.picked,s=Ra(t);s.includes(this.blockField)||(this.blockField=s[0]??""),this.extra.replaceChildren(Z("span",{},`${t.called(n)}: `),Qn(s.map(a=>[a,a]),this.blockField,a=>{this.blockField=a,this.open("block")},"field of the block")),this.draw("Reading the frames \u2026");let r=t.moments(),o=r.length>1&&r.every(a=>a.time===r[0].time);await t.history(n,this.blockField,(a,l)=>{if(e!==this.stamp)return!1;let c=r.slice(0,a.length).map(h=>o?h.step:h.time);return this.curves=[{name:this.blockField,unit:l,x:c,bySteps:o,values:[...a],dash:!1}],this.draw(""),!0})}changed(){this.tab==="line"&&this.object.offsetParent!==null&&this.openLine()}openLine(){let e=this.lines();this.extra.replaceChildren(),e.some(t=>t.parts.length>0)&&this.extra.append(Z("button",{type:"button",title:"The values as a table (CSV)",onclick:()=>yr(new Blob([qC(e)],{type:"text/csv"}),$C(e))},"CSV")),this.curves=e.filter(t=>t.parts.length>0).map(XC),this.draw("Press d and click two points of the picture to see the field along the line between them.")}mark(e){this.now=e;for(let t of this.plots)t.redraw(!1)}draw(e){for(let n of this.plots)n.destroy();if(this.plots=[],this.body.replaceChildren(),this.curves.length===0){this.body.append(Z("p.hint",{},e));return}let t=new Map;for(let n of this.curves){let s=`${n.unit==="-"?`- ${n.name}`:n.unit} ${n.bySteps} ${n.along??""}`;t.set(s,[...t.get(s)??[],n])}for(let n of t.values())this.body.append(this.one(n));this.resize()}one(e){let t=e[0].unit==="-"?"":e[0].unit,{bySteps:n,along:s}=e[0],r=Z("figure.chart",{}),o=getComputedStyle(document.documentElement),a=o.getPropertyValue("--ink2").trim(),l=o.getPropertyValue("--line").trim(),c=o.getPropertyValue("--accent").trim(),h=[...new Set(e.map(b=>b.name))],u=e.every(b=>/unbalanced/.test(b.name)),f=(b,m)=>m.map(g=>g===null?"":Bt(g)),d={width:300,height:180,title:(s?`${s}`:"")+(h.length===1?h[0]+(t?` [${t}]`:""):t?`[${t}]`:""),cursor:{sync:{key:s===void 0?"riprap":"riprap line"},drag:{x:!0,y:!1}},legend:{live:!0},scales:{x:{time:!1},y:u?{distr:3}:{}},axes:[{stroke:a,grid:{stroke:l,width:1},ticks:{stroke:l,width:1},size:28,values:f},{stroke:a,grid:{stroke:l,width:1},ticks:{stroke:l,width:1},size:62,values:f}],series:[{label:s!==void 0?"distance [m]":n?"step":"time [s]",value:(b,m)=>m===null?"\u2013":Bt(m)},...e.map((b,m)=>({label:b.dash?`${b.name} (2)`:b.name,stroke:Ff[h.indexOf(b.name)%Ff.length]??Ff[m%Ff.length],width:1.4,...b.dash?{dash:[6,4]}:{},points:{show:b.x.length<40&&s===void 0,size:4},spanGaps:s===void 0,value:(g,x)=>x==null?"\u2013":Bt(x)}))],hooks:{draw:[b=>{if(s!==void 0)return;let m=b.valToPos((n?this.now?.step:this.now?.time)??0,"x",!0),{left:g,top:x,width:_,height:y}=b.bbox;m<g||m>g+_||(b.ctx.save(),b.ctx.strokeStyle=c,b.ctx.setLineDash([]),b.ctx.lineWidth=1.5*devicePixelRatio,b.ctx.beginPath(),b.ctx.moveTo(m,x),b.ctx.lineTo(m,x+y),b.ctx.stroke(),b.ctx.restore())}]}},p=new Gn(d,ZC(e,u),r);return p.over.addEventListener("click",()=>{let{left:b}=p.cursor;s===void 0&&b!==void 0&&b!==null&&b>=0&&this.seek(p.posToVal(b,"x"),n)}),this.plots.push(p),r}resize(){let e=this.plots.length;if(e===0)return;let t=this.body.clientWidth,n=Math.max(1,Math.min(e,Math.floor(t/300))),s=Math.floor((t-24)/n)-12,r=e>n?190:Math.max(150,this.body.clientHeight-66);for(let o of this.plots)o.setSize({width:s,height:Math.min(r,320)})}retheme(){this.curves.length>0&&this.draw("")}};function XC({run:i,field:e,unit:t,parts:n},s,r){let o=[],a=[];n.forEach(({from:c,to:h,value:u},f)=>{f>0&&c>n[f-1].to*(1+1e-9)&&(o.push(.5*(n[f-1].to+c)),a.push(null)),o.push(c,h),a.push(u,u)});let l=r.length>1?`${i.summary.name}: `:"";return{name:e,unit:t,x:o,bySteps:!1,values:a,dash:!1,along:l}}function d_(i){return/[",\n]/.test(i)?`"${i.replaceAll('"','""')}"`:i}function qC(i){let{field:e,unit:t}=i[0],n=i.length>1,s=[...n?["run"]:[],"from [m]","to [m]","block","name",t==="-"?e:`${e} [${t}]`],r=i.flatMap(({run:o,parts:a})=>a.map(l=>[...n?[d_(o.summary.name)]:[],l.from,l.to,l.block,d_(o.called(l.block)),l.value].join(",")));return[s.join(","),...r,""].join(`
`)}function $C(i){return`${i[0].run.summary.name.replace(/\.run$/,"")}_${i[0].field}_line.csv`}function YC(i,e){return i.names.map((t,n)=>({name:t,unit:i.units[n],x:i.x,bySteps:i.bySteps,values:i.columns[n],dash:e}))}function Ra(i){return i.summary.names??jC(i.summary.fields??[])}function jC(i){return i.flatMap(e=>e.components===1?[e.name]:[e.name,...["x","y","z"].slice(0,e.components).map(t=>`${e.name}.${t}`)])}function ZC(i,e){let t=i.map(s=>{let r=Array.from(s.x),o=Array.from(s.values,a=>a===null||!Number.isFinite(a)||e&&a<=0?null:a);return[r,o]}),n=i[0].x;return i.every(s=>s.x===n)?[t[0][0],...t.map(s=>s[1])]:Gn.join(t)}var kf=class{constructor(e,t,n,s,r){this.runs=e;this.choices=t;this.actions=n;this.saved=s;this.dimension=r;this.object=Z("aside.panel",{"aria-label":"settings"}),this.rebuild(),t.listen(o=>{let a=["clipAt","clipDip","clipDirection","vectorSize"];(!this.object.querySelector("input[type=range]:active, input[type=range]:focus")||!o.every(c=>a.includes(c)))&&this.refill()})}runs;choices;actions;saved;dimension;object;blockBox=Z("div.numbers");status=Z("div.exportstate",{role:"status"});colourBox=Z("div");moveBox=Z("div");marksBox=Z("div");rebuild(e=this.dimension){this.dimension=e;let t=this.runs.filter(n=>n.summary.manifest?.preview&&n.summary.manifest.warnings.length>0);this.object.replaceChildren(...t.map(n=>kr(`Warnings (${n.summary.manifest.warnings.length})`,!0,...this.warnings(n))),kr("Colour",!0,this.colourBox),kr("Shape and view",!0,this.moveBox),kr("Vectors and contacts",!0,this.marksBox),kr("Block",!0,this.blockBox),kr("Views",!1,this.saved.object),kr("Save",!1,this.saveBox()),...this.runs.map((n,s)=>kr(this.runs.length>1?`Run ${s+1}`:"Run",!1,JC(n,this.warnings(n))))),this.refill(),this.blockBox.hasChildNodes()||this.showBlock(null)}warnings(e){return(e.summary.manifest?.warnings??[]).map(t=>{let n=gf(t,e.names);if(n.length===0)return Z("p.warning",{},t);let s=n.length===1?"Go to this block":`Go to these ${n.length} blocks`;return Z("button.warning",{type:"button",title:s,onclick:()=>this.actions.goTo(e,n)},t)})}refill(){this.colourBox.replaceChildren(...this.colourRows()),this.moveBox.replaceChildren(...this.moveRows()),this.marksBox.replaceChildren(...this.markRows())}colourRows(){let{choices:e}=this,t=e.now,n=[...new Set(this.runs.flatMap(l=>Ra(l)))],s=Qn([["","one colour"],...n.map(l=>[l,l])],t.field,l=>e.set(Bf(t,l)),"field"),r=tg(this.runs).map(l=>{let c=()=>e.set(Bf(t,l));return Z("button",{type:"button",title:"Colour by this field (q: the next)","aria-pressed":String(l===t.field),onclick:c},l||"one colour")}),o=[Rn("Field",s)];r.length>1&&o.push(Z("div.buttons",{},...r));let a=this.meaning(t.field);if(a&&o.push(Z("p.hint",{},a)),!t.field||cr.has(t.field))return o;if(o.push(Rn("Colours",Qn(Object.keys(so).map(l=>[l,l]),t.map,l=>e.set({map:l}),"colour map")),Rn("Range",Qn([["most","run, 98 % of blocks"],["run","whole run"],["frame","this frame"],["fixed","fixed"]],t.rangeMode,l=>{let[c,h]=this.actions.range();e.set({rangeMode:l,low:c,high:h})},"range of the colours"))),t.rangeMode==="fixed"){let l=(c,h)=>{let u=Z("input",{type:"number",step:"any",value:String(t[c]),"aria-label":h});return u.addEventListener("change",()=>{Number.isFinite(u.valueAsNumber)&&e.set({[c]:u.valueAsNumber})}),u};o.push(Rn("From, to (SI)",l("low","lowest value"),l("high","highest value")))}return o.push(Z("div.checks",{},Xn("powers of ten",t.log,l=>e.set(l&&t.map==="blue-red"?{log:l,map:"light"}:{log:l}),"Logarithmic colours"),Xn("only in range",t.only,l=>e.set({only:l}),"Hide blocks whose value is outside the range"))),o}kindOf(e,t){if(t===void 0)return"";let n=this.runs.filter(s=>s.summary.manifest).map(s=>bm(s,e,t));return n.every(s=>s===n[0])?n[0]??"":""}meaning(e){let t=e.replace(/\.(x|y|z|magnitude)$/,"");for(let n of this.runs){let s=n.summary.manifest?.fields?.find(r=>r.name===t||r.name===`block.${t}`);if(s)return s.meaning}return""}moveRows(){let{choices:e,actions:t}=this,n=e.now,s=Z("input",{type:"range",min:"0",max:"4",step:"0.02",value:String(Math.log10(Math.max(1,n.exaggeration))),"aria-label":"exaggeration"}),r=Z("output",{},`\xD7 ${Bt(n.exaggeration,3)}`),o=()=>Number((10**Number(s.value)).toPrecision(2));s.addEventListener("input",()=>r.textContent=`\xD7 ${Bt(o(),3)}`),s.addEventListener("change",()=>e.set({exaggeration:o()}));let a=(c,h,u)=>Z("button",{type:"button",title:h,onclick:u},c);return[Rn("Displacement",s,r),Z("div.buttons",{},a("true","Displacements as they are",()=>e.set({exaggeration:1})),a("visible","Exaggerate so that the largest displacement can be seen",()=>e.set({exaggeration:t.niceExaggeration()})),a("fit","All in view (f)",()=>t.fit()),...this.dimension===3?["x","y","z"].map(c=>a(c,`Look along ${c}`,()=>t.fit(c))):[],a("line","Distance, and the field along a line: click both ends; again: remove it (d)",t.line)),Z("div.checks",{},Xn("edges",n.edges,c=>e.set({edges:c}),"Draw the edges of the blocks (e)"),this.dimension===3?Xn("shadows",n.shadows,c=>e.set({shadows:c}),"Shadows of the sun, and darker hollows (y)"):null,this.runs.some(c=>c.hasField("held"))?Xn("supports",n.supports,c=>e.set({supports:c}),"Outline the blocks that supports hold or move (u)"):null,...this.conditionChecks()),...(n.shadows||n.edges)&&t.unshaded()?[Z("p.hint",{},t.unshaded())]:[],Rn("Joints",Qn([["","not shown"],["set","by set (direction)"],...this.runs.some(c=>c.conditions)?[["interface","by interface"]]:[]],n.joints,c=>e.set({joints:c}),"joints")),...this.cutRows()]}conditionChecks(){let{choices:e}=this,t=e.now,n=this.runs.flatMap(r=>r.conditions??[]),s=[];return n.some(r=>r.faces.length>0)&&s.push(Xn("boundaries",t.boundaries,r=>e.set({boundaries:r}),"Colour the faces that are held, moved, viscous or loaded (h)")),n.some(r=>r.loads.length>0||r.faces.some(o=>o.kind==="loaded"))&&s.push(Xn("loads",t.loads,r=>e.set({loads:r}),"Arrows of given forces and pressures, at their full size (l)")),n.some(r=>r.water.length>0)&&s.push(Xn("water table",t.water,r=>e.set({water:r}),"The water table of the phase (w)")),s}cutRows(){let{choices:e}=this,t=e.now,n=this.dimension===3?["x","y","z"]:["x","y"],s=Qn([["","nothing"],...n.map(l=>[l,`along ${l}`]),["free",this.dimension===3?"any plane":"any line"]],t.clipAxis,l=>e.set({clipAxis:l}),"clipping plane"),r=[Rn("Cut away",s)];if(!t.clipAxis)return r;let o=(l,c,h,u)=>{let f=Z("input",{type:"range",min:"0",max:String(c),step:String(h),value:String(t[l]),"aria-label":u}),d=l==="clipAt"?null:Z("output",{},`${t[l]}\xB0`);return f.addEventListener("input",()=>{d&&(d.textContent=`${f.value}\xB0`),e.set({[l]:Number(f.value)})}),[f,d]},a=Qn([["flat","flat, through blocks"],["whole","whole blocks"]],t.clipFlat?"flat":"whole",l=>e.set({clipFlat:l==="flat"}),"kind of cut");return a.title="Flat, or whole blocks (b)",r.push(Rn("Cut is",a),Rn("Plane at",...o("clipAt",1,.002,"place of the cut"))),t.clipAxis==="free"&&(this.dimension===2?r.push(Rn("Angle from x",...o("clipDip",180,1,"angle of the cut"))):r.push(Rn("Dip",...o("clipDip",90,1,"dip of the cut")),Rn("Dip direction",...o("clipDirection",360,1,"dip direction of the cut")))),r.push(Z("div.checks",{},Xn("flip",t.clipFlip,l=>e.set({clipFlip:l}),"Remove the other side (o)"))),r}markRows(){let{choices:e}=this,t=e.now,n=new Set(this.runs.flatMap(p=>(p.summary.fields??[]).filter(b=>b.components>1).map(b=>b.name))),s=["displacement","velocity","force"].filter(p=>n.has(p)),r=this.runs.map(p=>p.summary.held).filter(p=>p!==void 0),o=s.filter(p=>r.every(b=>b.vectors.includes(p))),a=r.every(p=>p.contacts),c=s.length>o.length||!a?[Z("p.hint",{},"This report holds only part of the arrows and contacts; riprap view shows all.")]:[],h=this.runs.some(p=>p.hasStress);if(o.length===0&&!a&&!h)return c;let u=this.runs.some(p=>p.conditions?.water.some(b=>b.seeps)),f=a?["contact force",...u?["seepage flow"]:[]]:[],d=[Rn("Arrows",Qn([["","none"],...[...o,...f].map(p=>[p,p])],t.vectors,p=>e.set({vectors:p}),"vectors"))];if(h&&d.push(Z("div.checks",{},Xn("stress",t.stress,p=>e.set({stress:p}),"Principal stresses as crosses: blue in compression, red in tension (a)"))),t.vectors||t.stress||t.chains){let p=Z("input",{type:"range",min:"-1",max:"1",step:"0.05",value:String(Math.log10(t.vectorSize)),"aria-label":"size of arrows, crosses and chains"});p.addEventListener("input",()=>e.set({vectorSize:10**Number(p.value)})),d.push(Rn("Size",p))}if(this.runs.some(p=>p.frames>1)&&d.push(...this.trailRows()),!a)return[...d,...c];if(d.push(Z("div.checks",{},Xn("contacts",t.contacts,p=>e.set({contacts:p}),"Points at contacts, coloured by state (c)"),Xn("force chains",t.chains,p=>e.set({chains:p}),"Tubes from block to block, as thick and dark as the contact force (n)"),this.dimension===3?Xn("cracks",t.cracks,p=>e.set({cracks:p}),"Broken and open faces between glassy blocks (k)"):null,this.runs.some(p=>p.summary.bolts)?Xn("bolts",t.bolts,p=>e.set({bolts:p}),"Bars of bolts, red in tension, blue in compression (r)"):null,this.runs.some(p=>(p.summary.manifest?.sources??[]).length>0)?Xn("charges",t.charges,p=>e.set({charges:p}),"Stars where charges are (i)"):null)),t.contacts){let p=this.actions.states();d.push(Z("div.checks",{},...hr.flatMap((b,m)=>{if(m>1&&!p[m])return[];let g=Xn(b.name,t.states[m],x=>e.set({states:t.states.map((_,y)=>y===m?x:_)}));return g.style.setProperty("--chip",b.colour),g.classList.add("chipped"),g})))}return[...d,...c]}trailRows(){let{choices:e}=this,{trails:t,trailColour:n}=e.now,s=[["","none"],["moving","of all that moved"],["picked","of the picked block"]],r=[["speed","by speed"],["block","by block"]];return[Rn("Trails",Qn(s,t,o=>e.set({trails:o}),"trails")),...t?[Rn("Coloured",Qn(r,n,o=>e.set({trailColour:o}),"colour of trails"))]:[]]}saveBox(){let e=(t,n,s)=>Z("button",{type:"button",title:n,onclick:s},t);return Z("div",{},Z("div.buttons",{},e("Picture","PNG of what is shown (s)",this.actions.picture),e("All frames","PNG of every frame, in a zip",this.actions.sequence),e("Film","WebM with every frame once, at the frames per second of the bar below",this.actions.film)),this.saved.pathRow(this.dimension),this.status)}say(e){this.status.textContent=e}showBlock(e,t=""){if(!e){this.blockBox.replaceChildren(Z("p.hint",{},t||"Click a block to see its numbers and their history."));return}let n=e.columns.filter(r=>r.name!=="block").map(r=>{let o=r.values.map(h=>typeof h=="number"?h:Number.NaN),a=o.length>1?`${sn(Math.hypot(...o),r.unit)}`:r.unit==="-"?Bt(o[0]??Number.NaN):sn(o[0]??Number.NaN,r.unit),l=cr.has(r.name)?this.kindOf(r.name,o[0]):"",c=o.length>1?`(${o.map(h=>Bt(h,3)).join(", ")})`:"";return Z("tr",{},Z("td",{},r.name),Z("td",{},l||a,c?Z("small",{},c):null))}),s=e.groups.length?[p_(e.groups.length>1?"groups":"group",e.groups.join(", "))]:[];this.blockBox.replaceChildren(Z("div.buttons.pickhead",{},Z("b",{},e.name||`block ${e.block}`),Z("button",{type:"button",onclick:this.actions.history},"history"),Z("button",{type:"button",onclick:this.actions.unpick,title:"Deselect (Esc)"},"clear")),Z("table",{},...e.name?[p_("number",String(e.block))]:[],...s,...n))}};function tg(i){let e=new Set(i.flatMap(t=>Ra(t)));return[e.has("material")?"material":"",...["displacement","velocity"].filter(t=>e.has(t))]}function Bf(i,e){return{field:e,map:ku(e),log:!1,rangeMode:i.rangeMode==="fixed"?"most":i.rangeMode}}function p_(i,e){return Z("tr",{},Z("td",{},i),Z("td",{},e))}function kr(i,e,...t){return Z("details",{open:e},Z("summary",{},i),...t)}function JC(i,e){let{manifest:t,name:n}=i.summary;if(!t)return Z("p.hint",{},"This folder cannot be read.");let s=[["folder",n],["scene",t.scenario],["case",[t.variant,t.case].filter((a,l,c)=>a&&a!=="default"&&c.indexOf(a)===l).join(", ")],["ended",t.ended+(t.message?`: ${t.message}`:"")],["model time",sn(t.time,"s")],["steps",t.steps.toLocaleString("en")],["time step",sn(t.dt,"s")],["wall time",`${Bt(t.wall_time,3)} s on ${t.threads} thread${t.threads===1?"":"s"}`],["started",t.started.replace("T"," ").replace("Z"," UTC")],["riprap",t.riprap],["state hash",t.state_hash.slice(0,16)]],o=["scenario.resolved.toml","manifest.json","histories.csv","energy.csv","events.jsonl"].flatMap(a=>{let l=i.source.file(a);return l?[Z("a",{href:l,target:"_blank",rel:"noopener"},a)," "]:[]});return Z("div",{},Z("table",{},...s.filter(([,a])=>a).map(([a,l])=>Z("tr",{},Z("td",{},a),Z("td",{},l)))),...t.preview?[]:e,Z("p.files",{},...o))}var lc={field:"material",map:"light",rangeMode:"most",low:0,high:1,log:!1,exaggeration:1,edges:!0,shadows:!0,supports:!1,boundaries:!1,loads:!1,water:!0,joints:"",clipAxis:"",clipAt:.5,clipFlip:!1,clipFlat:!0,clipDip:60,clipDirection:240,only:!1,vectors:"",vectorSize:1,stress:!1,contacts:!1,states:[!1,!0,!0,!0,!0,!0,!0,!0],cracks:!1,bolts:!0,chains:!1,trails:"",trailColour:"speed",notes:!0,charges:!0,speed:10,loop:!0},zf=class{now={...lc,states:[...lc.states]};listeners=[];set(e){Object.assign(this.now,e);for(let t of this.listeners)t(Object.keys(e))}listen(e){this.listeners.push(e)}};var ng=i=>i.toArray();function KC(i,e,t){let{stage:n,scale:s}=i,r=new I(...i.blocks.shape.info.origin),{position:o,target:a,zoom:l}=n.standpoint(),c=e.field!==""&&!cr.has(e.field),h=Object.entries(e).filter(([u,f])=>JSON.stringify(f)!==JSON.stringify(lc[u]));return{name:t,eye:ng(o.add(r)),target:ng(a.add(r)),up:ng(n.camera.up),angle:n.camera instanceof gn?n.camera.fov:null,zoom:l,field:e.field,log:e.log,range:c?[s.low,s.high]:null,exaggeration:e.exaggeration,cut:i.cutAway(e),bolts:e.bolts,settings:Object.fromEntries(h)}}function b_(i,e){let t=new I(...i.blocks.shape.info.origin);return{position:new I(...e.eye).sub(t),target:new I(...e.target).sub(t),zoom:e.zoom}}function QC(i,e,t){if(e==="views"&&t.length>1){let n=t.map(l=>b_(i,l)),s=new Kr(n.map(l=>l.position)),r=n.map(l=>l.target),a=r.every(l=>l.distanceTo(r[0])<1e-9)?null:new Kr(r);return l=>{let c=l*(n.length-1),h=Math.min(n.length-2,Math.floor(c)),u=Hn.lerp(n[h].zoom,n[h+1].zoom,c-h);return{position:s.getPoint(l),target:a?.getPoint(l)??r[0].clone(),zoom:u}}}if(e==="round"&&!i.flat){let{position:n,target:s,zoom:r}=i.stage.standpoint(),o=i.stage.camera.up.clone().normalize();return a=>({position:n.clone().sub(s).applyAxisAngle(o,2*Math.PI*a).add(s),target:s.clone(),zoom:r})}return null}function m_(i){return Array.isArray(i)&&i.length===3&&i.every(e=>Number.isFinite(e))}function g_(i){let e=n=>new Mn(`views.json: ${n}.`,"Save the file again from the viewer."),t;try{t=JSON.parse(i).views}catch(n){throw e(String(n))}if(!Array.isArray(t))throw e("it has no list `views`");return t.map((n,s)=>{let{name:r,eye:o,target:a}=n;if(typeof r!="string"||!m_(o)||!m_(a))throw e(`view ${s+1} needs a name, an eye and a target`);return{...{up:[0,0,1],angle:32,zoom:1,field:"displacement",log:!1,range:null,exaggeration:1,cut:null,bolts:!0},...n,name:r,eye:o,target:a,settings:n.settings??{}}})}var Hf=class{constructor(e,t,n){this.views=e;this.choices=t;this.annotate=n;let s=Z("input",{type:"text",placeholder:"name","aria-label":"name of the view",maxLength:60}),r=()=>{this.add(s.value.trim()||`view ${this.all.length+1}`),s.value=""};s.addEventListener("keydown",a=>{a.key==="Enter"&&r()});let o=(a,l,c)=>Z("button",{type:"button",title:l,onclick:c},a);this.object.append(Z("div.buttons",{},s,o("save view","Keep camera, colours and cut under this name",r),o("views.json","All saved views in a file: riprap shot RUN --views FILE --saved NAME draws them; in the run folder the viewer finds them again",()=>this.write())),this.list,this.noteRow(),this.noteList,this.said),this.fill()}views;choices;annotate;object=Z("div");path="";all=[];notes=[];noteList=Z("div.buttons");said=Z("p.hint",{role:"status"});list=Z("div.buttons");noteRow(){let e=Z("input",{type:"text",placeholder:"text","aria-label":"text of the note",maxLength:fm}),t=()=>{let n=e.value.trim();if(!n){this.said.textContent="Write a text first, then click its place.";return}this.said.textContent="Click its place: on a block it goes along with it.",this.annotate(n),e.value="",e.blur()};return e.addEventListener("keydown",n=>{n.key==="Enter"&&t()}),Z("div.buttons",{},e,Z("button",{type:"button",title:"Put this text on a block or a place of the model; it is kept with the views, and in pictures and films",onclick:t},"note"))}addNote(e){this.notes.push(e),this.kept()}pathRow(e){let t=[["","stays"],["views","through the saved views"],...e===3?[["round","once around"]]:[]];return Rn("Camera",Qn(t,this.path,n=>this.path=n,"camera of a film"))}move(){if(this.path==="views"&&this.all.length<2)throw new Error("Save two views or more: the camera goes through them in their order.");let e=this.views()[0];return e?.blocks?QC(e,this.path,this.all):null}async load(){let e=this.views()[0]?.run;if(e){try{let t=localStorage.getItem(this.key());t&&([this.all,this.notes]=[g_(t),dm(t)])}catch{}try{let t=e.summary.views?e.source.file("views.json"):void 0,n=t?await(await fetch(t)).text():null;if(n!==null){for(let r of g_(n))this.put(r);let s=(r,o)=>r.text===o.text&&r.block===o.block&&r.at.every((a,l)=>a===o.at[l]);for(let r of dm(n))this.notes.some(o=>s(r,o))||this.notes.push(r)}}catch(t){this.said.textContent=t instanceof Mn?`${t.what} ${t.hint}`:String(t)}this.fill()}}key(){return`riprap.views.${this.views()[0]?.run.summary.name??""}`}put(e){let t=this.all.findIndex(n=>n.name===e.name);t<0?this.all.push(e):this.all[t]=e}add(e){let t=this.views()[0];t?.blocks&&(this.put(KC(t,this.choices.now,e)),this.kept())}kept(){this.fill();try{localStorage.setItem(this.key(),this.text())}catch{}}text(){return JSON.stringify({views:this.all,notes:this.notes},null,1)}write(){this.all.length+this.notes.length===0?this.said.textContent="No views and no notes saved yet.":yr(new Blob([this.text()],{type:"application/json"}),"views.json")}fill(){this.list.replaceChildren(...this.all.map(e=>Z("span.saved",{},Z("button",{type:"button",title:"Go to this view",onclick:()=>this.go(e)},e.name),Z("button",{type:"button",title:`Remove ${e.name}`,"aria-label":`remove ${e.name}`,onclick:()=>this.remove(e)},"\xD7")))),this.noteList.replaceChildren(...this.notes.map(e=>{let t=()=>{this.notes=this.notes.filter(n=>n!==e),this.kept()};return Z("span.saved",{},Z("span",{},e.text),Z("button",{type:"button",title:"Remove this note","aria-label":`remove note ${e.text}`,onclick:t},"\xD7"))})),this.said.textContent="";for(let e of this.views())e.notes=this.notes,e.stage.redraw()}remove(e){this.all=this.all.filter(t=>t!==e),this.kept()}go(e){let{states:t,...n}={...lc,...e.settings,field:e.field};this.choices.set({...n,states:[...t]});for(let s of this.views())s.blocks&&s.stage.follow(b_(s,e))}};var Vf=class{constructor(e,t,n){this.choices=e;this.show=t;this.ahead=n;this.slider=Z("input.scrub",{type:"range",min:"0",max:"0",step:"1",value:"0","aria-label":"time"}),this.slider.addEventListener("input",()=>{this.pause(),this.following=!1,this.go(Number(this.slider.value))}),this.label=Z("output.time",{"aria-live":"off"}),this.playButton=Vi("play","Play (space)",()=>this.toggle()),this.playButton.classList.add("primary");let s=[1,2,5,10,20,30].map(o=>[String(o),`${o}/s`]),r=Qn(s,String(e.now.speed),o=>e.set({speed:Number(o)}),"frames per second");r.title="Frames per second",this.object=Z("div.timeline",{},Vi("first","First frame (Home)",()=>{this.go(0)}),Vi("back","One frame back (\u2190)",()=>this.step(-1)),this.playButton,Vi("next","One frame forward (\u2192)",()=>this.step(1)),Vi("last","Last frame (End)",()=>{this.go(this.moments.length-1)}),this.slider,this.label,r)}choices;show;ahead;object;moments=[];at=0;playing=!1;following=!1;slider;label;playButton;busy=!1;wanted=null;setMoments(e){this.moments=e,this.slider.max=String(Math.max(0,e.length-1)),this.object.classList.toggle("empty",e.length===0),this.say()}say(){let e=this.moments[this.at],t=e?cm(e):"";this.slider.value=String(this.at),this.label.replaceChildren(Z("b",{title:t},t||"no frames"),Z("small",{},this.moments.length?`${this.at+1} of ${this.moments.length}`:"")),this.slider.setAttribute("aria-valuetext",t)}async go(e){let t=this.moments.length-1;if(this.at=Math.min(Math.max(0,e),Math.max(0,t)),this.say(),!(t<0)){if(this.busy){this.wanted=this.at;return}this.busy=!0;try{await this.show(this.moments[this.at])}finally{this.busy=!1}if(this.wanted!==null){let n=this.wanted;this.wanted=null,n!==e&&await this.go(n)}}}async seek(e,t){let n=r=>Math.abs((t?r.step:r.time)-e),s=0;this.moments.forEach((r,o)=>{n(r)<n(this.moments[s])&&(s=o)}),this.following=!1,await this.go(s)}step(e){this.pause(),this.following=!1,this.go(this.at+e)}toggle(){this.playing?this.pause():this.play()}pause(){this.playing=!1,this.face()}face(){this.playButton.replaceChildren(nd(this.playing?"pause":"play"));let e=this.playing?"Pause (space)":"Play (space)";this.playButton.title=e,this.playButton.setAttribute("aria-label",e)}async play(){if(!(this.playing||this.moments.length<2)){for(this.playing=!0,this.following=!1,this.face(),this.at>=this.moments.length-1&&await this.go(0);this.playing;){let e=performance.now();if(this.at>=this.moments.length-1&&!this.choices.now.loop)break;let t=(this.at+1)%this.moments.length;for(let s of[1,2]){let r=this.moments[(t+s)%this.moments.length];r!==void 0&&this.ahead(r)}await this.go(t),await new Promise(s=>requestAnimationFrame(s));let n=1e3/this.choices.now.speed-(performance.now()-e);n>1&&await new Promise(s=>setTimeout(s,n))}this.pause()}}};var v_="riprap-theme",y_=window.matchMedia("(prefers-color-scheme: dark)"),Gf=document.documentElement,eP=Gf.dataset.theme;function tP(){try{return localStorage.getItem(v_)}catch{return null}}function x_(){Gf.dataset.theme=tP()??eP??(y_.matches?"dark":"light")}function Wf(i=()=>{}){x_(),y_.addEventListener("change",()=>{x_(),i()})}function __(){let i=Gf.dataset.theme==="dark"?"light":"dark";Gf.dataset.theme=i;try{localStorage.setItem(v_,i)}catch{}}var iP=1e3,sP=["field","rangeMode","vectors","contacts","cracks","bolts","chains","stress","supports","joints"],Xf=class{constructor(e,t){this.host=e;this.loading=t}host;loading;choices=new zf;runs=[];panes=[];silent=new Set;timeline;panel=null;plots=null;saved=new Hf(()=>this.panes.map(({view:e})=>e),this.choices,e=>this.setMeasuring(!0,e));stages=Z("div.stages");badge=Z("span.badge");title=Z("h1");measuring=!1;writing="";work=null;async start(e){this.runs=await Promise.all(e.map(o=>nf.open(o)));let t=this.runs.filter(o=>!o.summary.problem);await Promise.all(t.map(o=>o.readModel())),this.chooseField(t),this.timeline=new Vf(this.choices,o=>this.showMoment(o),o=>{for(let{view:a}of this.panes)a.prefetch(a.run.frameAt(o),this.choices.now)}),this.layout(t);for(let{view:o}of this.panes)o.others=t.filter(a=>a!==o.run);this.timeline.setMoments(this.moments(t)),this.refreshHead(),t.some(o=>o.summary.live)&&(this.timeline.following=!0,this.news());for(let{view:o}of this.panes)o.hasty=!0;await this.timeline.go(this.timeline.moments.length-1);for(let o of this.panes)this.refreshPane(o);let[n,...s]=this.panes;if(n)for(let o of s)o.view.stage.follow(n.view.stage.standpoint());let r=this.panes[0]?.view.flat??!0;this.panel?.rebuild(r?2:3),this.panel?.refill(),document.documentElement.dataset.shown="true";for(let{view:o}of this.panes)o.hasty=!1;await this.timeline.go(this.timeline.at),await this.saved.load(),document.documentElement.dataset.ready="true"}chooseField(e){let t=e.flatMap(n=>Ra(n));t.includes("removable_type")&&(this.choices.now.field="removable_type"),t.includes(this.choices.now.field)||(this.choices.now.field=""),this.choices.now.map=ku(this.choices.now.field)}moments(e){let t=(s,r)=>s.time-r.time||s.nth-r.nth,n=e.flatMap(s=>s.moments()).sort(t);return n.filter((s,r)=>r===0||t(s,n[r-1])>0)}layout(e){for(let l of this.runs)l.summary.problem?this.stages.append(rP(l.summary.name,l.summary.problem)):this.addPane(l);let t=e[0],n=t?.summary.fields.some(l=>l.components===3)?3:2;this.panel=new kf(this.runs,this.choices,this.actions(),this.saved,n),this.plots=new Of(e,(l,c)=>{this.timeline.seek(l,c)},()=>this.lines());let s=this.shortcuts(),r=zv(s);Bv(s,this.host);let o=l=>()=>{this.host.classList.toggle(l),l==="with-plots"&&this.openPlots()},a=Z("header",{},this.title,this.badge,Z("span.spacer"),Vi("camera","Save a picture (s)",()=>{this.save("picture")}),Vi("plots","Histories (p)",o("with-plots")),Vi("theme","Light or dark (t)",()=>this.flipTheme()),Vi("help","Keys and mouse (?)",()=>r.showModal()),Vi("menu","Panel (m)",o("no-panel")));this.host.replaceChildren(a,Z("main",{},Z("div.middle",{},this.stages,this.plots.object),this.panel.object),this.timeline.object,r,this.loading.object),window.innerWidth<760&&this.host.classList.add("no-panel"),this.choices.listen(l=>{this.changed(l)}),Wf(()=>this.themed()),this.themed(),e.length>0&&t.summary.tables[0]&&window.innerHeight>820&&window.innerWidth>1100&&(this.host.classList.add("with-plots"),this.openPlots())}addPane(e){let t=Z("div.stage"),n={host:t,view:new xf(e,t,this.loading),legend:Z("div.legendhost"),banner:Z("div.banner",{role:"alert",hidden:!0}),head:Z("div.panehead"),triad:Z("div.triad",{"aria-hidden":"true"}),notes:Z("div.notes")};t.append(n.notes,n.head,n.legend,n.banner,n.triad),this.stages.append(t),this.panes.push(n);let{view:s}=n;s.stage.onMove=o=>{for(let a of this.panes)a!==n&&a.view.stage.follow(o)},s.stage.onDrawn=()=>{aP(n),n.notes.replaceChildren(...Tv(s.labels()))},s.onChange=()=>this.refreshPane(n);let r=null;s.stage.canvas.addEventListener("pointerdown",o=>r=[o.clientX,o.clientY]),s.stage.canvas.addEventListener("pointerup",o=>{r&&Math.hypot(o.clientX-r[0],o.clientY-r[1])<5&&o.button===0&&(this.writing?this.write(s,o.clientX,o.clientY):this.measuring?this.measure(s,o.clientX,o.clientY):this.pick(n,s.pickAt(o.clientX,o.clientY))),r=null}),s.stage.canvas.addEventListener("webglcontextlost",o=>{o.preventDefault(),this.banner(n,{what:"The browser has lost its graphics context.",hint:"Reload the page."})}),e.frames===0&&this.banner(n,ig(e))}measure(e,t,n){let s=e.placeAt(t,n);if(!s)return;let r=e.ends.length===1?[e.ends[0],s]:[s];this.layLine(r),!(r.length<2)&&(this.setMeasuring(!1),this.host.classList.add("with-plots"),this.plots?.open("line"))}layLine(e){for(let t of this.panes)t.view.lay(e),this.refreshPane(t);this.plots?.changed()}write(e,t,n){let s=e.placeAt(t,n);!s||!e.blocks||!e.motion||(this.saved.addNote(Ev(this.writing,s,e.pickAt(t,n),e.blocks,e.motion,this.choices.now.exaggeration)),this.setMeasuring(!1))}setMeasuring(e,t=""){this.measuring=e,this.writing=t,this.host.classList.toggle("measuring",e)}lines(){let{field:e}=this.choices.now;return this.panes.flatMap(({view:t})=>{let{pieces:n,length:s}=t.along();if(!t.values||s===0)return[];let r=n.map(o=>({from:o.from*s,to:o.to*s,block:t.blocks.ids[o.block],value:t.values[o.block]}));return[{run:t.run,field:e,unit:t.unit,length:s,parts:r}]})}async showMoment(e){await Promise.all(this.panes.map(({view:n})=>n.show(n.run.frameAt(e),this.choices.now)));for(let n of this.panes)this.refreshPane(n);this.plots?.mark(e),this.plots?.changed();let t=this.panes.find(n=>n.view.picked!==null);t&&!this.timeline.playing&&await this.showNumbers(t)}refreshPane(e){let{view:t}=e;e.legend.replaceChildren(Dv(vf(t,this.choices.now),t.scale)),t.run.frames>0&&this.banner(e,t.trouble??t.run.summary.note??oP(t.run)),e.host.classList.toggle("stale",t.trouble!==null);let{summary:n}=t.run;if(this.runs.length>1){let s=t.run.saidAt(t.frame);e.head.replaceChildren(Z("b",{},n.manifest.title||n.name),Z("span",{},` ${n.name}${s?` \xB7 ${s}`:""}`))}t.stage.canvas.dataset.frame=String(t.frame),t.stage.canvas.dataset.faces=String(t.blocks?.visibleFaces??0),t.stage.canvas.dataset.blocks=String(t.blocks?.count??0),t.stage.canvas.dataset.cut=String(t.blocks?.cutBlocks??0)}banner(e,t){e.banner.hidden=t===null,t&&e.banner.replaceChildren(Z("b",{},t.what),Z("span",{},t.hint))}async changed(e){let t=this.choices.now;if(e.some(n=>sP.includes(n))){let n=this.timeline.moments[this.timeline.at];await Promise.all(this.panes.map(({view:s})=>s.show(n?s.run.frameAt(n):Math.max(0,s.frame),t))),(e.includes("contacts")||e.includes("chains"))&&this.panel?.refill()}else for(let{view:n}of this.panes)n.apply(t,e.includes("exaggeration"));for(let n of this.panes)this.refreshPane(n);this.plots?.changed()}async pick(e,t){for(let n of this.panes)n.view.pick(n===e?t:null);this.plots?.setPicked(e.view.run,t),t===null?this.panel?.showBlock(null):await this.showNumbers(e)}async showNumbers(e){let{view:t}=e;if(t.picked!==null)try{this.panel?.showBlock(await t.run.block(t.frame,t.picked))}catch(n){let{what:s,hint:r}=ur(n);this.panel?.showBlock(null,`${s.replace(/\.$/,"")}. ${r}`)}}openPlots(){this.host.classList.contains("with-plots")&&this.plots?.open(this.plots.tab)}actions(){let e=()=>this.panes[0]?.view;return{fit:t=>{let n=e();if(n?.fit(t),n)for(let s of this.panes.slice(1))s.view.stage.follow(n.stage.standpoint())},picture:()=>{this.save("picture")},sequence:()=>{this.save("sequence")},film:()=>{this.save("film")},niceExaggeration:()=>Math.min(...this.panes.map(({view:t})=>t.niceExaggeration())),unpick:()=>{for(let t of this.panes)this.pick(t,null)},goTo:(t,n)=>{let s=this.panes.find(r=>r.view.run===t);if(s){s.view.goTo(n);for(let r of this.panes)r!==s&&r.view.stage.follow(s.view.stage.standpoint());this.pick(s,n[0]??null)}},line:()=>this.toggleLine(),history:()=>{this.host.classList.add("with-plots"),this.plots?.open("block")},range:()=>{let t=e()?.scale;return t?[t.low,t.high]:[0,1]},unshaded:()=>this.panes.map(({view:t})=>t.unshaded).find(t=>t!=="")??"",states:()=>hr.map((t,n)=>this.panes.some(({view:s})=>(s.between?.counts[n]??0)>0))}}async save(e){let t=this.panes.filter(r=>r.view.blocks).map(r=>r.view);if(t.length===0)return;if(this.work){this.work.abort();return}let n=new AbortController;this.work=n;let s=r=>(this.panel?.say(`${Math.round(100*r)} %; choose it again to stop`),!n.signal.aborted);try{e==="picture"?await wm(t,this.choices.now):await Sm[e]([t,this.choices.now,this.timeline,this.saved.move()],s),this.panel?.say(n.signal.aborted?"stopped":"saved")}catch(r){this.panel?.say(ur(r).what)}finally{this.work=null}}shortcuts(){let{choices:e,timeline:t}=this,n=this.actions(),s=c=>()=>e.set({exaggeration:Math.min(1e4,Math.max(1,Number((e.now.exaggeration*c).toPrecision(2))))}),r=()=>{let h=["","x","y","z","free"].filter(u=>u!=="z"||this.panes.some(({view:f})=>!f.flat));e.set({clipAxis:h[(h.indexOf(e.now.clipAxis)+1)%h.length]})},o=()=>{let c=tg(this.runs),h=c[(c.indexOf(e.now.field)+1)%c.length];h!==void 0&&e.set(Bf(e.now,h))},a=()=>{let c=["","set","interface"];e.set({joints:c[(c.indexOf(e.now.joints)+1)%c.length]})},l=c=>h=>e.set({clipAt:Math.min(1,Math.max(0,Number((e.now.clipAt+(h?10:1)*c).toFixed(4))))});return[{keys:[" "],label:"space",what:"play, pause",act:()=>t.toggle()},{keys:["ArrowLeft"],label:"\u2190",what:"one frame back (shift: ten)",act:c=>t.step(c?-10:-1)},{keys:["ArrowRight"],label:"\u2192",what:"one frame forward (shift: ten)",act:c=>t.step(c?10:1)},{keys:["Home"],label:"Home",what:"first frame",act:()=>{t.go(0)}},{keys:["End"],label:"End",what:"last frame",act:()=>{t.go(t.moments.length-1)}},{keys:["g"],label:"g",what:"follow a run in progress",act:()=>this.follow()},{keys:["f"],label:"f",what:"all in view",act:()=>n.fit()},...["x","y","z"].map((c,h)=>({keys:[String(h+1)],label:String(h+1),what:`look along ${c} (in space)`,act:()=>n.fit(c)})),{keys:["e"],label:"e",what:"edges",act:()=>e.set({edges:!e.now.edges})},{keys:["y"],label:"y",what:"light and shadow (in space)",act:()=>e.set({shadows:!e.now.shadows})},{keys:["q"],label:"q",what:"colours: materials, displacement, velocity",act:o},{keys:["u"],label:"u",what:"supports",act:()=>e.set({supports:!e.now.supports})},{keys:["h"],label:"h",what:"boundaries: held, moved, viscous, loaded faces (in space)",act:()=>e.set({boundaries:!e.now.boundaries})},{keys:["l"],label:"l",what:"loads: arrows",act:()=>e.set({loads:!e.now.loads})},{keys:["w"],label:"w",what:"water table",act:()=>e.set({water:!e.now.water})},{keys:["j"],label:"j",what:"joints: by set, by interface, not",act:a},{keys:["c"],label:"c",what:"contacts",act:()=>e.set({contacts:!e.now.contacts})},{keys:["n"],label:"n",what:"force chains: tubes as thick as the contact force",act:()=>e.set({chains:!e.now.chains})},{keys:["k"],label:"k",what:"cracks (in space)",act:()=>e.set({cracks:!e.now.cracks})},{keys:["r"],label:"r",what:"bolts: rods, red in tension, blue in compression",act:()=>e.set({bolts:!e.now.bolts})},{keys:["i"],label:"i",what:"charges: stars where they are (in space)",act:()=>e.set({charges:!e.now.charges})},{keys:["a"],label:"a",what:"principal stresses as crosses",act:()=>e.set({stress:!e.now.stress})},{keys:["d"],label:"d",what:"distance, and the field along a line: click both ends (again: remove it)",act:()=>this.toggleLine()},{keys:["v"],label:"v",what:"velocity arrows",act:()=>e.set({vectors:e.now.vectors?"":"velocity"})},{keys:["x"],label:"x",what:"cut away: along x, y, z, any plane, nothing",act:r},{keys:["b"],label:"b",what:"cut flat, or whole blocks",act:()=>e.set({clipFlat:!e.now.clipFlat})},{keys:["o"],label:"o",what:"cut away the other side",act:()=>e.set({clipFlip:!e.now.clipFlip})},{keys:[",",";","<"],label:",",what:"cut back (shift: ten times as far)",act:l(-.01)},{keys:[".",":",">"],label:".",what:"cut forward (shift: ten times as far)",act:l(.01)},{keys:["["],label:"[",what:"less exaggeration",act:s(.5)},{keys:["]"],label:"]",what:"more exaggeration",act:s(2)},{keys:["p"],label:"p",what:"histories",act:()=>this.toggle("with-plots")},{keys:["m"],label:"m",what:"panel",act:()=>this.toggle("no-panel")},{keys:["s"],label:"s",what:"save a picture",act:()=>{this.save("picture")}},{keys:["t"],label:"t",what:"light, dark",act:()=>this.flipTheme()},{keys:["Escape"],label:"Esc",what:"deselect the block; no note after all",act:()=>{this.writing&&this.setMeasuring(!1),n.unpick()}},{keys:["?"],label:"?",what:"this sheet",act:()=>document.querySelector("dialog.sheet")?.showModal()}]}toggleLine(){let e=this.measuring||this.panes.some(({view:t})=>t.ends.length>0);this.layLine([]),this.setMeasuring(!e)}toggle(e){this.host.classList.toggle(e),this.openPlots()}follow(){this.timeline.following=!this.timeline.following,this.refreshHead(),this.timeline.following&&this.timeline.go(this.timeline.moments.length-1)}news(){setTimeout(async()=>{let e=this.panes.map(r=>r.view.run),t=await Promise.allSettled(e.map(r=>r.refresh()));if(t.some(r=>r.status==="fulfilled"&&r.value)){location.reload();return}let n=this.moments(e),s=n.length!==this.timeline.moments.length;this.timeline.setMoments(n),this.refreshHead();for(let r of this.panes)r.view.run.summary.manifest?.preview&&this.refreshPane(r);if(s){if(this.timeline.following)await this.timeline.go(n.length-1);else for(let r of this.panes)this.refreshPane(r);for(let r of this.panes)r.view.run.frames===0&&this.banner(r,ig(r.view.run))}s&&this.plots&&this.plots.tab!=="block"&&this.openPlots(),this.panes.forEach((r,o)=>this.answered(r,t[o])),e.some(r=>r.summary.live)?this.news():this.panel?.rebuild()},iP)}answered(e,t){t.status==="rejected"?(this.silent.add(e),this.banner(e,ur(t.reason))):this.silent.delete(e)&&(e.view.run.frames===0?this.banner(e,ig(e.view.run)):this.refreshPane(e))}refreshHead(){let e=this.runs[0],{manifest:t,name:n}=e.summary,s=this.runs.map(l=>l.summary.manifest?.title||l.summary.name);this.title.textContent=[...new Set(s)].join(" | "),this.title.title=n,document.title=`${s[0]} \u2013 riprap`;let r=this.runs.some(l=>l.summary.live),o=this.runs.some(l=>l.summary.died),a=t?t.preview?"not run":r?"running":o?"unfinished":t.ended:"unreadable";this.badge.textContent=r&&this.timeline.following&&!t?.preview?"running, followed":a,this.badge.className=`badge ${a}`,this.badge.title=t?r?`step ${t.steps.toLocaleString("en")}; g follows the newest frame`:o?"The program that wrote this run has died. Its results so far are shown; riprap resume continues from the last checkpoint.":`${t.message||"all phases are complete"}; ${Bt(t.wall_time,3)} s`:""}flipTheme(){__(),this.themed()}themed(){let e=getComputedStyle(document.documentElement),t=e.getPropertyValue("--paper").trim(),n=e.getPropertyValue("--ink").trim();for(let{view:s}of this.panes)s.setTheme(t,n);this.plots?.retheme()}};function rP(i,e){return Z("div.cardhost",{},Z("div.card.problem",{role:"alert"},Z("h2",{},`${i} cannot be shown`),Z("p",{},e.what),Z("p.hint",{},e.hint)))}function oP(i){let{preview:e,message:t}=i.summary.manifest??{};return e&&t?{what:"The scene as saved cannot be shown.",hint:t}:null}function ig(i){return i.summary.live?{what:"No frame yet.",hint:"The run has started; the first frame will be shown when it is written."}:{what:"This run has no frames.",hint:'Request them in the scene and run it again: [[outputs]] frames = { every = "10 ms" }. Its histories are available (p).'}}function aP(i){let{view:e}=i;if(!e.blocks)return;let t=e.stage.triad(),n=e.flat?["x","y"]:["x","y","z"],s=["#d9483b","#2f9e57","#3576d6"],r=n.map((h,u)=>{let[f,d]=[32+24*t[u][0],32-24*t[u][1]],[p,b]=[32+30*t[u][0],32-30*t[u][1]];return`<line x1="32" y1="32" x2="${f}" y2="${d}" stroke="${s[u]}"/><text x="${p}" y="${b}" fill="${s[u]}">${h}</text>`}),o=e.stage.metresPerPixel(),a=90*o,l=10**Math.floor(Math.log10(a)),c=([5,2,1].find(h=>h*l<=a)??1)*l;i.triad.innerHTML=`<svg viewBox="0 0 64 64" width="64" height="64">${r.join("")}</svg><span class="bar" style="width:${(c/o).toFixed(1)}px">${sn(c,"m",3)}</span>`}async function lP(){let i=document.getElementById("riprap-run");if(i?.textContent)return[new tf(new Map(Object.entries(JSON.parse(i.textContent))))];let e=await fetch("api/runs"),{runs:t}=await e.json();return Array.from({length:t},(n,s)=>new ef(s,rg))}Wf();var sg=document.getElementById("app")??Z("div"),rg=new Qu;sg.append(rg.object);try{await new Xf(sg,rg).start(await lP())}catch(i){let{what:e,hint:t}=ur(i);sg.replaceChildren(Z("div.card.problem",{role:"alert"},Z("h1",{},"The viewer cannot start"),Z("p",{},e),Z("p.hint",{},t)))}
